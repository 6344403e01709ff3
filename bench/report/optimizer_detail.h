// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is told of one optimizer on one problem beside its row: each of its trials, how it was set, how far its numbers
/// and times can be trusted.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/analysis.h>
#include <nodal/record.h>
#include <nodal/registry.h>

namespace nodal::report {

/// One trial.
struct RepeatDetail {
  int repeat = 0;
  End end = End::failed;
  std::string reason;
  std::optional<double> quality, relative_error;
  std::optional<std::int64_t> evaluations;  ///< empty where the trial's process died, like `to_best` …
  std::optional<double> seconds, to_best;   ///< … and `seconds`, unless it was killed after some
  std::string contamination;                ///< empty for a clean one
  std::vector<CurvePoint> curve;            ///< best quality so far over seconds
};

/// An option as it was asked for and as it ran. What a study can't set, and what one wasn't asked for, is empty.
struct OptionDetail {
  std::string name;
  std::optional<Value> requested, effective;
  bool varies = false;  ///< trials ran with different ones: the first one's is told
  std::string help = {};

  /// It ran with another value than was asked for.
  [[nodiscard]] bool differs() const { return requested && effective && !(*requested == *effective); }
};

/// The worst of all trials.
struct HealthDetail {
  std::optional<double> cost_error, drift, residual;
  std::int64_t refused = 0;
  std::optional<double> stationarity, least_digits;  ///< of the audits
};

struct OptimizerDetail {
  std::string label, use, summary, reference;  ///< the last two where this build knows the method
  bool knows_request = false;                  ///< the manifest says what was asked for
  std::vector<OptionDetail> options;
  std::vector<RepeatDetail> repeats;
  HealthDetail health;
  std::vector<std::string> conditions;  ///< each once: processor, jobs, cores
  std::string status;                   ///< what the library said of the first trial
};

/// `requested`: the manifest's options of the optimizer; nullptr where an older build wrote it. Trials of one optimizer
/// on one problem, at least one; what those don't say whose process died is told of the others.
[[nodiscard]] OptimizerDetail detail_of(const std::string& label, const Value* requested,
                                        std::span<const TrialRecord* const> trials, const Registry& registry);

}  // namespace nodal::report
