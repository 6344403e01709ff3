// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What stored trials say: pure functions of records, the same for table, CSV and page.
///
/// Gap = (G − G*)/(G_start − G*). Work is counted in equivalent full values, the start's included: factorizations at
/// their own flops, the rest of the trial's flops (solves) spread evenly over its evaluations, divided by the flops of
/// one full value. For problems that count no flops it is evaluations. A trial whose process was killed or died has no
/// figures; it counts as failed and in the success rate. Medians over repeats count a trial that never reached a target
/// as infinitely long; "never" is an empty optional. A trial that starts at G* has reached every gap at 0:
/// `starts_at_best`.
///
/// Success is counted in distinct runs. Repeats are one observation, not several, when they began at one start (its
/// quality is the same to the last bit; of a trial that died, that of others of its repeat) and all of that start
/// agree:
///  - of a deterministic method on whether they got there;
///  - of others on having got there at the same evaluation with the same quality, so that all until then was the same:
///  a
///    multi-start method whose first run finds the best, say. What they drew at random afterwards has decided nothing.
/// Where one doesn't agree, or failed before, each trial counts on its own, so that the share of those that got there
/// is what it was; so do random ones that never got there, which drew their own numbers to the end.

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// What the cost of a trial is counted in; factorizations are 0 of problems that count none.
enum class Axis { seconds, evaluations, work, factorizations };
inline constexpr std::array kAxes = {Axis::seconds, Axis::evaluations, Axis::work, Axis::factorizations};
/// Something for each, where `kAxes` has it.
template <class Figure>
using ByAxis = std::array<Figure, kAxes.size()>;
[[nodiscard]] std::string_view to_string(Axis axis) noexcept;

/// Gaps at which time to target is stated.
inline constexpr std::array<double, 8> kTargetGaps = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
/// The gap of the success rate and of the baseline's multiples unless said otherwise.
inline constexpr double kDefaultGap = 1e-2;

struct Quartiles {
  double lower = 0.0, median = 0.0, upper = 0.0;
};

/// Linear interpolation between order statistics (Hyndman & Fan type 7); empty for no values.
[[nodiscard]] std::optional<Quartiles> quartiles(std::vector<double> values);

/// No other trial ran beside it, of its comparison or another one in its store; of a record that doesn't say, nobody
/// knows better.
[[nodiscard]] bool ran_alone(const TrialRecord& record);
[[nodiscard]] bool ran_alone_undisturbed(const TrialRecord& record);  ///< … and has no `contamination`
/// Those of an optimizer's trials whose seconds count, in tables, curves, expected times and verdicts alike: that ran
/// alone and undisturbed; where none did, that were undisturbed; where none was, all. Trials that failed tell no times,
/// but stand for those that never get there: of them as many count as keep their share of all trials. Everything that
/// isn't seconds is of all trials.
[[nodiscard]] std::vector<const TrialRecord*> timed_trials(std::span<const TrialRecord* const> trials);

/// The problem of a table: what G is measured against.
struct ProblemReference {
  std::string label;
  double best_quality = 0.0;         ///< G*
  std::string origin;                ///< who says so
  bool provisional = false;          ///< true when it is merely the best of these trials
  bool unimproved = false;           ///< provisional, and no trial improved its start: gaps to it mean nothing
  std::optional<double> given = {};  ///< a G* that was given and that a trial is below of: all is measured against
                                     ///< that trial's then, also what was stored before it
};

struct TargetRow {
  double gap = 0.0;
  std::size_t runs = 0, reached = 0;       ///< distinct runs, and how many of these got to the gap
  double success_rate = 0.0;               ///< reached / runs
  ByAxis<std::optional<double>> median;    ///< empty: never
  ByAxis<std::optional<double>> multiple;  ///< baseline's median over this one's; empty: never or no baseline
};

/// Medians over trials.
struct UnseenRow {
  double error = 0.0;       ///< at the best point
  double over_start = 0.0;  ///< times that of the trial's own start
  double least = 0.0;       ///< the least on the way, start and best point included
};

struct OptimizerRow {
  std::string label, use;
  bool baseline = false;
  std::size_t trials = 0;
  std::size_t failed = 0;                            ///< ended failed, timeout or crashed
  std::size_t starts = 0;                            ///< distinct ones
  bool deterministic = false;                        ///< the method: its repeats from one start measure time only
  std::size_t contaminated = 0;                      ///< trials whose times are not to be trusted: `contamination`
  std::size_t timed = 0;                             ///< `timed_trials`, but failures that ran otherwise
  bool timed_alone = true;                           ///< false: none ran alone and undisturbed, seconds are of others
  std::optional<Quartiles> quality, relative_error;  ///< of the best points
  std::optional<Quartiles> data_quality;             ///< … without the prior's share (PointSummary)
  std::optional<Quartiles> at_bounds;                ///< coordinates of the best points that lie at a bound
  std::optional<Quartiles> evaluations, factorizations, seconds, work;
  std::map<std::string, Quartiles> findings;  ///< by name, of the trials that have one (Health::findings)
  std::optional<UnseenRow> unseen;            ///< of the trials whose best point has an unseen error
  std::size_t unseen_missing = 0;             ///< trials in which it can't be told of the best point
  std::array<TargetRow, kTargetGaps.size()> targets;
  std::vector<std::string> reasons;  ///< of failed trials, each once

  [[nodiscard]] const TargetRow& target(double gap) const;
};

/// What is held out of a problem, and how its trials were judged by it (unseen.h).
struct UnseenSummary {
  std::vector<std::string> reported, chosen_by;  ///< names; the second of a validated stop
  std::optional<double> start;                   ///< unseen error at the problem's start
};

struct ProblemTable {
  ProblemReference reference;
  std::optional<double> start_quality, start_relative_error;
  std::vector<Axis> axes;  ///< by which its trials can be told apart, as people choose between them: seconds,
                           ///< evaluations, factorizations where anything was factorized twice, work where it is
                           ///< counted in flops
  bool has_prior = false;  ///< qualities, gaps and curves have a prior's share in them; relative errors haven't
  std::optional<UnseenSummary> unseen;  ///< of the first trial that has any
  bool start_is_best = false;           ///< `starts_at_best` of that start
  std::vector<OptimizerRow> rows;       ///< in the order asked for
};

/// An optimizer in a table: label, `use`, and whether it is the baseline.
struct RowRequest {
  std::string label, use;
  bool baseline = false;
  bool deterministic = false;
};

/// `best_known` without a value, or above the best of the records by more than it is known to: that best, marked
/// provisional.
[[nodiscard]] ProblemTable make_table(const std::string& problem_label, const std::optional<KnownOptimum>& best_known,
                                      std::span<const RowRequest> optimizers, std::span<const TrialRecord> records);

/// True where nothing is left to be found: the start's quality is not above G* by more than G* is known to (1e-9 of it
/// where it was measured, else half a unit of the last digit it was given with, at most 1e-4 of it), or the start is a
/// perfect fit, but for rounding: there (G − G*)/(G_start − G*) is rounding over rounding. False, but for a perfect
/// fit, where G* is `unimproved`: that nobody found anything says nothing about the start.
[[nodiscard]] bool starts_at_best(const PointSummary& start, const ProblemReference& reference);

/// Where a trial stood on an axis when it first had quality ≤ the given one; empty: never.
[[nodiscard]] std::optional<double> first_reached(const TrialRecord& record, double quality, Axis axis);
/// The same for a gap of the trial's own start: 0 where it `starts_at_best`.
[[nodiscard]] std::optional<double> gap_reached(const TrialRecord& record, const ProblemReference& reference,
                                                double gap, Axis axis);
/// The trial's position on an axis at a point of its trace, and at its end.
[[nodiscard]] double position(const TrialRecord& record, const TracePoint& point, Axis axis);
[[nodiscard]] double end_position(const TrialRecord& record, Axis axis);

/// Best quality so far over an axis: median and quartiles over an optimizer's trials at logarithmically spaced
/// positions. A trial that has ended keeps its best. Begins where the median trial has its first point. Over seconds of
/// the `timed_trials`.
struct CurvePoint {
  double position = 0.0;
  Quartiles quality;
};
[[nodiscard]] std::vector<CurvePoint> make_curve(std::span<const TrialRecord* const> trials, Axis axis,
                                                 std::size_t points = 120);
/// The same of the unseen error at the best point so far, where trials have one: `quality` is that error. It may rise.
[[nodiscard]] std::vector<CurvePoint> make_unseen_curve(std::span<const TrialRecord* const> trials, Axis axis,
                                                        std::size_t points = 120);

}  // namespace nodal
