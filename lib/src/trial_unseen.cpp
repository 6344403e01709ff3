// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_unseen.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include <fmt/format.h>

namespace nodal {

namespace {

// Of a race's own arithmetic, or so much that it takes a second or two: what is looked at afterwards.
constexpr double kMostShare = 0.1, kMostFlops = 2e9;

}  // namespace

TrialUnseen::TrialUnseen(const Problem& problem, Evaluator& evaluator, const Meter& meter, TrialRecord& record)
    : problem_(problem), evaluator_(evaluator), meter_(meter), record_(record) {}

void TrialUnseen::fail(const std::string& what) {
  record_.reason += (record_.reason.empty() ? "" : "; ") + what;
  record_.end = End::failed;
}

// By counts, not by the clock: equal races look at equal points.
std::size_t TrialUnseen::most_points() const {
  if (!(record_.flops_per_value > 0.0)) return KeptPoints::kMost;
  const double allowed = std::max(kMostFlops, kMostShare * record_.work.flops) / record_.flops_per_value;
  return static_cast<std::size_t>(
      std::clamp(allowed, static_cast<double>(KeptPoints::kFewest), static_cast<double>(KeptPoints::kMost)));
}

// By evaluation. What the race saw as no number has no place in a record.
std::vector<const KeptPoint*> TrialUnseen::candidates() const {
  std::vector<const KeptPoint*> points;
  for (const KeptPoint& point : meter_.kept())
    if (point.at.evaluation < best_.at.evaluation) points.push_back(&point);
  points.push_back(&best_);
  std::erase_if(points, [](const KeptPoint* point) { return !std::isfinite(point->at.quality); });
  return points;
}

void TrialUnseen::measure() {
  const std::vector<std::string> names = problem_.held_out();
  if (names.empty() || !meter_.has_best()) return;
  record_.unseen.emplace().names = names;
  best_ = meter_.best();
  const std::vector<const KeptPoint*> all = candidates();
  std::vector<std::int64_t> evaluations;
  for (const KeptPoint* point : all) evaluations.push_back(point->at.evaluation);
  try {
    for (const std::size_t i : evenly_spaced(evaluations, most_points())) measure_at(*all[i]);
  } catch (const std::exception& error) {
    fail(fmt::format("evaluating what is held out threw: {}", error.what()));
  } catch (...) {
    fail("evaluating what is held out threw an exception that is no std::exception");
  }
}

void TrialUnseen::measure_at(const KeptPoint& point) {
  UnseenRecord& unseen = *record_.unseen;
  std::vector<double> errors(unseen.names.size());
  if (evaluator_.held_out_errors(point.x, errors) != Status::ok) {
    ++unseen.failed;
    return;
  }
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!std::isfinite(errors[i])) {
      fail(fmt::format("the held-out error of {} at evaluation {} is {}", unseen.names[i], point.at.evaluation,
                       errors[i]));
      ++unseen.failed;
      return;
    }
  unseen.points.push_back({point.at, std::move(errors)});
  points_.push_back(&point);
}

void TrialUnseen::note_finding() {
  if (!record_.unseen || !record_.best) return;
  if (const UnseenPoint* best = record_.unseen->at(record_.best->evaluation))
    record_.health.findings.push_back({kUnseenFinding, record_.unseen->error(*best)});
}

std::optional<KeptPoint> TrialUnseen::choose() {
  if (!record_.unseen || points_.empty()) return std::nullopt;
  UnseenRecord& unseen = *record_.unseen;
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < points_.size(); ++i)  // of equal ones the one that is fitted better
    if (unseen.choosing_error(unseen.points[i]) <= unseen.choosing_error(unseen.points[chosen])) chosen = i;
  const KeptPoint& point = *points_[chosen];
  unseen.stop = ValidatedStop{point.at.evaluation, best_.at.evaluation,
                              std::isfinite(best_.at.quality) ? best_.at.quality : point.at.quality};
  std::erase_if(record_.trace, [&](const TracePoint& p) { return p.evaluation >= point.at.evaluation; });
  record_.trace.push_back(point.at);
  return point;
}

}  // namespace nodal
