// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/kept_points.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nodal {

namespace {

double octaves(std::int64_t evaluation) { return std::log2(1.0 + static_cast<double>(evaluation)); }

}  // namespace

void KeptPoints::begin(std::size_t coordinates) {
  const std::size_t bytes = std::max<std::size_t>(1, coordinates * sizeof(double));
  most_ = std::clamp(kMostBytes / bytes, kFewest, kMost);
  points_.reserve(most_ + 1);
  boundary_ = 0;
}

std::int64_t KeptPoints::interval(std::int64_t evaluation) const {
  return static_cast<std::int64_t>(octaves(evaluation) / length_);
}

void KeptPoints::keep(const TracePoint& at, double cost, std::span<const double> x) {
  // Where a best was taken back, the one before it may be kept already, or be of the interval of the last that was.
  const bool again = !points_.empty() && points_.back().at.evaluation == at.evaluation;
  const bool same = again || (points_.size() > 1 && interval(points_.back().at.evaluation) == interval(at.evaluation));
  if (!same) points_.emplace_back();
  points_.back().at = at;
  points_.back().cost = cost;
  points_.back().x.assign(x.begin(), x.end());
  while (points_.size() > most_) thin();
}

void KeptPoints::moved_to(std::int64_t evaluation) {
  if (most_ == 0) return;
  evaluation = std::max<std::int64_t>(evaluation, 0);
  const std::int64_t here = interval(evaluation);
  boundary_ = static_cast<std::int64_t>(std::exp2(static_cast<double>(here + 1) * length_) - 1.0);
  boundary_ = std::max(boundary_, evaluation + 1);
  while (interval(boundary_) <= here) ++boundary_;  // exp2 and log2 round
}

void KeptPoints::forget_after(std::int64_t evaluation) {
  while (!points_.empty() && points_.back().at.evaluation > evaluation) points_.pop_back();
}

// Of two neighbours that come to lie in one interval the later one stays; the start is on its own.
void KeptPoints::thin() {
  length_ *= 2.0;
  std::size_t kept = 1;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const bool ends =
        i + 1 == points_.size() || interval(points_[i + 1].at.evaluation) != interval(points_[i].at.evaluation);
    if (ends) std::swap(points_[kept++], points_[i]);
  }
  points_.resize(kept);
}

std::vector<std::size_t> evenly_spaced(std::span<const std::int64_t> evaluations, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (evaluations.empty()) return chosen;
  const double last = octaves(evaluations.back());
  // Evaluation 0 is alone in interval 0.
  const auto interval = [&](std::size_t i) {
    return last > 0.0 ? std::ceil(octaves(evaluations[i]) / last * static_cast<double>(most - 1)) : 0.0;
  };
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    const bool ends = i + 1 == evaluations.size() || interval(i + 1) != interval(i);
    if (evaluations.size() <= most || ends) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace nodal
