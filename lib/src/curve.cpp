// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/analysis.h>

#include <algorithm>
#include <cmath>

namespace nodal {

namespace {

// What is drawn of a trial.
struct Way {
  const TrialRecord* trial;
  std::vector<TracePoint> points;
};

// One trial read along the axis: positions ascend over calls, so the walk is linear in its points.
class Walk {
 public:
  Walk(const Way& way, Axis axis) : way_(way), axis_(axis) {}

  // What holds at a position; empty before the first point.
  std::optional<double> at(double where) {
    while (next_ < way_.points.size() && position(*way_.trial, way_.points[next_], axis_) <= where) ++next_;
    return next_ == 0 ? std::nullopt : std::optional(way_.points[next_ - 1].quality);
  }

 private:
  const Way& way_;
  Axis axis_;
  std::size_t next_ = 0;
};

std::vector<const TrialRecord*> counting(std::span<const TrialRecord* const> trials, Axis axis) {
  return axis == Axis::seconds ? timed_trials(trials) : std::vector(trials.begin(), trials.end());
}

// The axis is logarithmic: evaluation 0 and second 0 stand at its left end.
double left_end(std::span<const Way> ways, Axis axis) {
  if (axis != Axis::seconds) return 1.0;
  std::vector<double> first;
  for (const Way& way : ways)
    if (!way.points.empty()) first.push_back(position(*way.trial, way.points.front(), axis));
  const std::optional<Quartiles> q = quartiles(std::move(first));
  return q ? std::max(q->median, 1e-7) : 0.0;
}

double right_end(std::span<const Way> ways, Axis axis) {
  double last = 0.0;
  for (const Way& way : ways) last = std::max(last, end_position(*way.trial, axis));
  return last;
}

std::vector<CurvePoint> curve_of(std::span<const Way> ways, Axis axis, std::size_t points) {
  std::vector<CurvePoint> curve;
  const double left = left_end(ways, axis), right = right_end(ways, axis);
  if (points < 2 || left <= 0.0 || right < left) return curve;
  std::vector<Walk> walks;
  for (const Way& way : ways) walks.emplace_back(way, axis);
  for (std::size_t i = 0; i < points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points - 1);
    const double where = i + 1 == points ? right : left * std::pow(right / left, share);
    std::vector<double> qualities;
    for (Walk& walk : walks)
      if (const std::optional<double> quality = walk.at(where)) qualities.push_back(*quality);
    // With fewer than half of the trials on the way, the median would be that of the quick ones.
    if (2 * qualities.size() < ways.size()) continue;
    if (const std::optional<Quartiles> q = quartiles(std::move(qualities))) curve.push_back({where, *q});
  }
  return curve;
}

}  // namespace

std::vector<CurvePoint> make_curve(std::span<const TrialRecord* const> trials, Axis axis, std::size_t points) {
  std::vector<Way> ways;
  for (const TrialRecord* trial : counting(trials, axis)) ways.push_back({trial, trial->trace});
  return curve_of(ways, axis, points);
}

std::vector<CurvePoint> make_unseen_curve(std::span<const TrialRecord* const> trials, Axis axis, std::size_t points) {
  std::vector<Way> ways;
  for (const TrialRecord* trial : counting(trials, axis)) {
    if (!trial->unseen || trial->unseen->points.empty()) continue;
    Way& way = ways.emplace_back(Way{trial, {}});
    for (const UnseenPoint& point : trial->unseen->points) {
      way.points.push_back(point.at);
      way.points.back().quality = trial->unseen->error(point);
    }
  }
  return curve_of(ways, axis, points);
}

}  // namespace nodal
