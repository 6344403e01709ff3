// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How long optimizers take to targets and how they converge, from the records of one problem: the figures of
/// statistics/ over trials.
///
/// Success   is counted in distinct runs (analysis.h); a trial that reached a gap and failed afterwards has reached it.
/// Times     are of trials that were not disturbed (`contamination`), as far as the optimizer has such.
/// Refused   A target is no target where gap · (G_start − G*) is below what G* is known to: half a unit of its last
///           digit where it was given, 1e-9 of it where it was measured. G_start is the least of the trials' starts
///           that is not the best already.
/// Cost      optimizers × gaps × axes × 1,000 drawings of as many trials, of which gaps that nobody reached, or all did
///           at one cost, need none.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nodal/analysis.h>
#include <nodal/statistics/anytime.h>
#include <nodal/statistics/run_length.h>
#include <nodal/verdict.h>

namespace nodal {

inline constexpr std::size_t kResamples = 1000;

struct TargetFigures {
  double gap = 0.0;
  std::optional<statistics::SuccessRate> success;        ///< of distinct runs, with Wilson's interval
  ByAxis<std::optional<double>> expected;                ///< ERT; empty: no trial got there
  ByAxis<std::optional<statistics::Interval>> interval;  ///< of the ERT, by bootstrap over trials
};

struct ConvergenceFigures {
  std::string optimizer;
  std::vector<TargetFigures> targets;  ///< without those that are refused
  /// AOCC, mean over trials: 1 for one that starts at the best already. Empty without limits.
  ByAxis<std::optional<double>> area;
  ByAxis<std::vector<statistics::RunLength>> lengths;  ///< of trials × targets, for their distribution
  ByAxis<std::vector<statistics::History>> attained;   ///< by each of the kAttainedShares, whole
};
inline constexpr std::array<double, 3> kAttainedShares = {0.25, 0.5, 0.75};

struct ProblemConvergence {
  std::string problem;
  double least_gap = 0.0;  ///< that is a target
  std::vector<double> refused;
  /// Between which areas are taken: gaps from 1 down to 1e-8, or to `least_gap` where that is larger; the last four
  /// decades of seconds, from 1 on for counts. To the budget, or the longest trial's end. Empty where that isn't more,
  /// and where nobody improved a start: gaps to G* mean nothing then.
  ByAxis<std::optional<statistics::AnytimeLimits>> limits;
  std::vector<ConvergenceFigures> optimizers;  ///< those with trials, in the order asked for
};

/// Gaps below this are refused; 0 where no trial has a start above G*.
[[nodiscard]] double least_target_gap(const Contest& contest);

/// `table` is make_table's of the same trials; budgets are the study's. Intervals are seeded by the labels of problem
/// and optimizer, the gap and the axis: the same records give the same figures.
[[nodiscard]] ProblemConvergence converge(const Contest& contest, const ProblemTable& table,
                                          std::optional<double> seconds = {}, std::optional<double> evaluations = {});

/// A trial's best quality so far.
[[nodiscard]] statistics::History quality_history(const TrialRecord& record, Axis axis);

}  // namespace nodal
