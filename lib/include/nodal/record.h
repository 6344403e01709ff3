// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is kept of a trial: one JSON line. docs/reading_a_report.md explains each field.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/error.h>
#include <nodal/meter.h>
#include <nodal/unseen.h>
#include <nodal/value.h>

namespace nodal {

/// Raised when a field changes its meaning or goes away; a store of a newer schema is refused.
inline constexpr int kRecordSchema = 1;

enum class End {
  budget,    ///< evaluations or seconds were spent
  target,    ///< the target gap was reached
  finished,  ///< the method ended by itself
  failed,    ///< the method or the problem threw, or a library refused its work
  timeout,   ///< hung past its deadline and was killed
  crashed,   ///< the process of the trial died
};

[[nodiscard]] std::string_view to_string(End end) noexcept;

/// What is kept of a reason, or of a library's words, [bytes]: some quote all that they were given.
inline constexpr std::size_t kMostOfAReason = 2000;

/// Empty entries were not measured, or don't exist for this problem.
struct PointSummary {
  std::optional<double> cost, quality, relative_error;  ///< with a prior the last is of the data's part of the cost
  std::optional<double> data_quality = {};              ///< of the data's part of the cost, where there is a prior
};

/// Of the points that were seen: the best, or under a validated stop the one that it chose.
struct BestPoint {
  std::int64_t evaluation = 0;
  PointSummary summary;  ///< of a fresh, refined evaluation at x
  std::vector<double> x;
  std::optional<std::int64_t> at_bounds = {};  ///< Space::at_bounds(x); records of version 0.1.0 lack it
};

struct Seconds {
  double total = 0.0;       ///< wall time of the whole trial
  double evaluation = 0.0;  ///< in the problem
  double optimizer = 0.0;   ///< in the method: total − evaluation − harness
  double harness = 0.0;     ///< start, final audit, the meter
  double to_best = 0.0;
  double cpu = 0.0;
  std::optional<double> warm_up = {};  ///< of the throw-away run before it, which is in no other figure
};

/// Under which conditions a trial ran: what its times are worth. Records of 0.1.0 and of `run_trial` alone have none.
struct Conditions {
  std::string build;           ///< `build_id` of the program that ran it
  std::string processor;       ///< as the system names it
  std::int64_t jobs = 1;       ///< trials that ran at once, at most
  std::int64_t cores = 1;      ///< that the program was allowed to use
  bool beside_others = false;  ///< another comparison wrote to the same store meanwhile
  bool stopped = false;        ///< its process was stopped and continued (Ctrl-Z, SIGSTOP, a frozen container)
  /// Older records don't say the following.
  std::optional<std::int64_t> core = {};       ///< that it was pinned to
  std::optional<std::int64_t> preempted = {};  ///< involuntary context switches: the core was taken from it
  std::optional<std::int64_t> waited = {};     ///< voluntary ones: it waited for something
  /// Time of a fixed piece of arithmetic shortly before, over its least time in this comparison: 1.3 on a core that is
  /// 1.3 times as slow as it was at its fastest.
  std::optional<double> pace = {};
  /// Time of the first evaluations in the warm-up, over that of the same ones after it.
  std::optional<double> cold = {};
};

/// What an independent path says of the best point when the trial is over: a fresh evaluator, which shares nothing with
/// the race's.
struct AuditRecord {
  /// max_i |P(x − g/f)_i − x_i|, with the cost f, its gradient g and P onto the box: the share of the cost by which it
  /// still falls per unit of the steepest coordinate that no bound holds. Empty for problems without gradients, and
  /// for perfect fits and costs below zero.
  std::optional<double> stationarity = {};
  std::optional<double> digits = {};  ///< of the race's cost that the fresh one has, −log10 of relative_drift(), ≤ 16
};

struct ClaimRecord {
  std::optional<double> cost;
  std::optional<bool> x_equals_best;
  std::optional<std::int64_t> evaluations;
  std::string status;
};

struct TrialRecord {
  int schema = kRecordSchema;
  std::string key;
  std::int64_t attempt = 1;        ///< 1 to 1e9; of two records with one key the one of the later attempt counts
  std::string problem, optimizer;  ///< labels
  std::string use;
  int repeat = 0;
  std::uint64_t seed = 0;  ///< of the trial's stream; below 2^53, so that every JSON reader keeps it
  End end = End::failed;
  bool limited = false;  ///< finished by a limit of the method's own, not by convergence; older records don't say
  std::string reason;    ///< at most kMostOfAReason bytes, with "…" where it went on
  Value options;         ///< effective
  PointSummary start;
  std::optional<BestPoint> best;  ///< none when no point had a finite cost
  Counts counts;
  Work work;
  double flops_per_value = 0.0;  ///< of one full value (the start's): the unit of "equivalent full values"; in `work`
  Seconds seconds;
  std::optional<Conditions> conditions;
  std::vector<TracePoint> trace;
  std::optional<ClaimRecord> claimed;
  std::optional<MovesReport> moves;  ///< how single changes were priced; its drift stands in `health`
  Health health;
  std::optional<AuditRecord> audit;    ///< older records lack it
  std::optional<UnseenRecord> unseen;  ///< of problems that hold something out; older records lack it
};

/// A trial that got less of a processor core than this was disturbed, [1], unless it was so short that the clock can't
/// tell [s].
inline constexpr double kLeastCoreShare = 0.9;
inline constexpr double kShortestToldSeconds = 0.02;

/// Why a trial's times are not to be trusted, for people: "got 0.42 of a core"; several reasons are separated by "; ".
/// Empty for a clean one. Its other figures hold, unless seconds ended it: then it searched less than it could have.
[[nodiscard]] std::string contamination(const TrialRecord& record);

/// Ended failed, timeout or crashed.
[[nodiscard]] bool is_failure(End end) noexcept;
/// The trial's process was killed or died: it left no figures but, where it was killed, how long it ran.
[[nodiscard]] bool has_died(End end) noexcept;

/// A record or store of a newer schema than this build knows: somebody's result, to be left alone.
class NewerSchemaError : public InputError {
 public:
  using InputError::InputError;
};

/// One line, without the newline. Numbers survive the round trip.
[[nodiscard]] std::string to_json_line(const TrialRecord& record);
/// InputError naming what is missing or wrong; NewerSchemaError.
[[nodiscard]] TrialRecord parse_record(std::string_view line, const std::string& name);

}  // namespace nodal
