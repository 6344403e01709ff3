// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is reported of a trial's start and best point: from fresh, refined evaluations after the search, so that both
/// are measured alike, whatever the race saw. What doesn't hold fails the trial, and its reason says so.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// The reason of a trial that its budget of evaluations ended: the clock had no part in that.
inline constexpr const char* kEvaluationsSpent = "evaluations spent";

class TrialAudit {
 public:
  TrialAudit(const Problem& problem, Evaluator& evaluator, const Meter& meter, TrialRecord& record)
      : problem_(problem), evaluator_(evaluator), meter_(meter), record_(record) {}

  /// Fills `start`, and the start's quality in the trace.
  void note_start(std::span<const double> x);
  /// Fills `best` and `health`, of the meter's best point, or of another one that was chosen. Call it last: the
  /// evaluator's health is of its last audit.
  void note_best(const std::optional<KeptPoint>& chosen = std::nullopt);

 private:
  void fail(const std::string& what);
  void note_health();
  Evaluation audit(const std::vector<double>& x, const std::string& what);
  PointSummary summarize(const Evaluation& evaluation, std::optional<double> data_cost, const std::string& what);
  template <class Get>
  std::optional<double> figure(const std::string& name, Get get);

  const Problem& problem_;
  Evaluator& evaluator_;
  const Meter& meter_;
  TrialRecord& record_;
};

}  // namespace nodal
