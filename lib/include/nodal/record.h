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

/// Empty entries were not measured, or don't exist for this problem.
struct PointSummary {
  std::optional<double> cost, quality, relative_error;
};

struct BestPoint {
  std::int64_t evaluation = 0;
  PointSummary summary;  ///< of a fresh, refined evaluation at x
  std::vector<double> x;
  std::optional<std::int64_t> at_bounds = {};  ///< Space::at_bounds(x); records of version 0.1 lack it
};

struct Seconds {
  double total = 0.0;       ///< wall time of the whole trial
  double evaluation = 0.0;  ///< in the problem
  double optimizer = 0.0;   ///< in the method: total − evaluation − harness
  double harness = 0.0;     ///< start, final audit, the meter
  double to_best = 0.0;
  double cpu = 0.0;
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
  std::string problem, optimizer;  ///< labels
  std::string use;
  int repeat = 0;
  std::uint64_t seed = 0;  ///< of the trial's stream; below 2^53, so that every JSON reader keeps it
  End end = End::failed;
  std::string reason;
  Value options;  ///< effective
  PointSummary start;
  std::optional<BestPoint> best;  ///< none when no point had a finite cost
  Counts counts;
  Work work;
  double flops_per_value = 0.0;  ///< of one full value (the start's): the unit of "equivalent full values"; in `work`
  Seconds seconds;
  std::vector<TracePoint> trace;
  std::optional<ClaimRecord> claimed;
  std::optional<MovesReport> moves;  ///< how single changes were priced; its drift stands in `health`
  Health health;
};

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
