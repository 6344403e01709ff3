// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/convergence.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/random.h>

#include "known_quality.h"
#include "never.h"

namespace nodal {

namespace {

constexpr double kLargestGap = 1.0, kSmallestGap = 1e-8;
constexpr double kDecadesOfSeconds = 1e4;

std::size_t at(Axis axis) { return static_cast<std::size_t>(axis); }

using Trials = std::vector<const TrialRecord*>;

Trials trials_of(const Contest& contest, const std::string& optimizer) {
  Trials trials;
  for (const TrialRecord* trial : contest.trials)
    if (trial->optimizer == optimizer) trials.push_back(trial);
  return trials;
}

Trials counting(const Trials& trials, Axis axis) { return axis == Axis::seconds ? timed_trials(trials) : trials; }

double longest_end(const Contest& contest, Axis axis) {
  double longest = 0.0;
  for (const TrialRecord* trial : contest.trials)
    if (!has_died(trial->end)) longest = std::max(longest, end_position(*trial, axis));
  return longest;
}

// Of a trial whose process died only the time is known, if it was killed: else it has cost as much as the longest.
statistics::RunLength length_of(const TrialRecord& trial, const ProblemReference& reference, double gap, Axis axis,
                                double longest) {
  const double end = end_position(trial, axis);
  return {gap_reached(trial, reference, gap, axis), has_died(trial.end) ? std::max(longest, end) : end};
}

bool all_alike(const std::vector<statistics::RunLength>& lengths) {
  return std::ranges::all_of(lengths, [&](const statistics::RunLength& length) {
    return length.reached && length.reached == lengths.front().reached;
  });
}

std::optional<statistics::Interval> interval_of(const std::vector<statistics::RunLength>& lengths, double expected,
                                                const std::string& name) {
  if (all_alike(lengths)) return statistics::Interval{expected, expected};
  return statistics::bootstrap_running_time(lengths, hash64(name), kResamples);
}

// What starts at the best has no gap to close.
double area_of(const statistics::History& qualities, const PointSummary& start, const ProblemReference& reference,
               const statistics::AnytimeLimits& limits) {
  if (!start.quality) return 0.0;
  const double unit = *start.quality - reference.best_quality;
  if (starts_at_best(start, reference) || !(unit > 0.0)) return 1.0;
  statistics::History gaps = qualities;
  for (statistics::BestSoFar& point : gaps) point.quality = (point.quality - reference.best_quality) / unit;
  return statistics::area_over_convergence(gaps, limits);
}

// Everything about one problem that does not depend on the optimizer.
struct Frame {
  const Contest& contest;
  const ProblemTable& table;
  ProblemConvergence& found;
  ByAxis<double> longest;
};

TargetFigures target_figures(const Frame& frame, const Trials& trials, const OptimizerRow& row, double gap,
                             ConvergenceFigures& figures) {
  TargetFigures target;
  target.gap = gap;
  target.success = statistics::success_rate(row.target(gap).reached, row.target(gap).runs);
  for (const Axis axis : kAxes) {
    std::vector<statistics::RunLength> lengths;
    for (const TrialRecord* trial : counting(trials, axis))
      lengths.push_back(length_of(*trial, frame.table.reference, gap, axis, frame.longest[at(axis)]));
    target.expected[at(axis)] = statistics::expected_running_time(lengths);
    if (const std::optional<double>& expected = target.expected[at(axis)])
      target.interval[at(axis)] =
          interval_of(lengths, *expected,
                      fmt::format("{}\n{}\n{}\n{}", frame.table.reference.label, row.label, gap, to_string(axis)));
    std::vector<statistics::RunLength>& all = figures.lengths[at(axis)];
    all.insert(all.end(), lengths.begin(), lengths.end());
  }
  return target;
}

void add_curves(const Frame& frame, const Trials& trials, Axis axis, ConvergenceFigures& figures) {
  const std::optional<statistics::AnytimeLimits>& limits = frame.found.limits[at(axis)];
  std::vector<statistics::History> histories;
  double areas = 0.0;
  for (const TrialRecord* trial : counting(trials, axis)) {
    histories.push_back(quality_history(*trial, axis));
    if (limits) areas += area_of(histories.back(), trial->start, frame.table.reference, *limits);
  }
  if (limits && !histories.empty()) figures.area[at(axis)] = areas / static_cast<double>(histories.size());
  figures.attained[at(axis)] = statistics::attainment_surfaces(histories, kAttainedShares);
}

bool has_gaps(const Contest& contest) {
  return !contest.reference.unimproved || std::ranges::any_of(contest.trials, [&](const TrialRecord* trial) {
    return starts_at_best(trial->start, contest.reference);
  });
}

std::optional<statistics::AnytimeLimits> limits_of(Axis axis, double to, double least_gap) {
  const double from = axis == Axis::seconds ? to / kDecadesOfSeconds : 1.0;
  const double smallest = std::max(kSmallestGap, least_gap);
  if (!(from > 0.0 && from < to && smallest < kLargestGap)) return std::nullopt;
  return statistics::AnytimeLimits{from, to, kLargestGap, smallest};
}

}  // namespace

double least_target_gap(const Contest& contest) {
  const ProblemReference& reference = contest.reference;
  const double best = reference.best_quality;
  double span = kNever;
  for (const TrialRecord* trial : contest.trials)
    if (trial->start.quality && *trial->start.quality > best && !starts_at_best(trial->start, reference))
      span = std::min(span, *trial->start.quality - best);
  if (span == kNever) return 0.0;
  return (reference.provisional ? measured_to(best) : known_to(best)) / span;
}

statistics::History quality_history(const TrialRecord& record, Axis axis) {
  statistics::History history;
  for (const TracePoint& point : record.trace) {
    const double cost = position(record, point, axis);
    // Two of one tick of the clock: the later is the better.
    if (!history.empty() && cost <= history.back().cost)
      history.back().quality = point.quality;
    else
      history.push_back({cost, point.quality});
  }
  return history;
}

ProblemConvergence converge(const Contest& contest, const ProblemTable& table, std::optional<double> seconds,
                            std::optional<double> evaluations) {
  ProblemConvergence found;
  found.problem = table.reference.label;
  found.least_gap = least_target_gap(contest);
  for (const double gap : kTargetGaps)
    if (gap < found.least_gap) found.refused.push_back(gap);
  Frame frame{contest, table, found, {}};
  const bool gaps = has_gaps(contest);
  for (const Axis axis : kAxes) {
    const double longest = frame.longest[at(axis)] = longest_end(contest, axis);
    const std::optional<double> budget = axis == Axis::seconds       ? seconds
                                         : axis == Axis::evaluations ? evaluations
                                                                     : std::nullopt;
    if (gaps) found.limits[at(axis)] = limits_of(axis, budget.value_or(longest), found.least_gap);
  }
  for (const OptimizerRow& row : table.rows) {
    const Trials trials = trials_of(contest, row.label);
    if (trials.empty()) continue;
    ConvergenceFigures& figures = found.optimizers.emplace_back();
    figures.optimizer = row.label;
    for (const double gap : kTargetGaps)
      if (gap >= found.least_gap) figures.targets.push_back(target_figures(frame, trials, row, gap, figures));
    for (const Axis axis : kAxes) add_curves(frame, trials, axis, figures);
  }
  return found;
}

}  // namespace nodal
