// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a reader came for: which optimizer to take with how much time or how many evaluations, who ties with it, how
/// sure that is, and what it holds for. Figures are verdicts' (verdict.h); here they become words.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/convergence.h>
#include <nodal/value.h>
#include <nodal/verdict.h>

namespace nodal::report {

/// What an answer holds for.
struct Scope {
  std::optional<double> seconds, evaluations;  ///< the study's budget, where it is known
  std::vector<std::string> processors;         ///< of the trials
  std::string first_run, last_run;             ///< days, UTC; empty where the stores don't say
};

/// Verdicts under the usual limits, in their order.
struct ProblemAnswer {
  std::string problem;
  std::vector<Verdict> verdicts;
};

struct Answer {
  Scope scope;
  std::size_t trials = 0, disturbed = 0, failed = 0;
  std::vector<Verdict> verdicts;        ///< over all problems
  std::vector<ProblemAnswer> problems;  ///< where they are several
  [[nodiscard]] bool empty() const noexcept { return verdicts.empty(); }
};

/// Budget, processors and days from a manifest and records.
[[nodiscard]] Scope scope_of(const Value& manifest, std::span<const TrialRecord> records);
[[nodiscard]] Answer make_answer(std::span<const Contest> contests, Scope scope);

/// "1 ms", "1,000 evaluations", "0.5 s (the budget)", "all evaluations".
[[nodiscard]] std::string limit_text(const Limit& limit, const Scope& scope);
/// "p = 0.012", "p < 0.001".
[[nodiscard]] std::string p_text(double p);

/// One limit, or several that have the same answer, as cells of a small table and as a sentence.
struct AnswerRow {
  std::string limits;  ///< "1 ms, 10 ms"
  std::string take;    ///< "gauss-newton"; "–" where there is nothing to take
  std::string value;   ///< "G 0.7376 [0.7376, 0.7380], 20 starts"
  std::string ties;    ///< "nlopt-slsqp (equal digits), multi-start L-BFGS (p = 0.3)"
  std::string next;    ///< "nlopt-ccsaq: 0.8123 (p = 0.001, Â = 0.97)"
  [[nodiscard]] std::string sentence() const;
};
/// `name` is what the quality is called. Of more than `most` ties the rest is counted.
[[nodiscard]] std::vector<AnswerRow> answer_rows(std::span<const Verdict> verdicts, const Scope& scope,
                                                 const std::string& name, std::size_t most = 100);

/// What it holds for, a sentence each.
[[nodiscard]] std::vector<std::string> scope_lines(const Answer& answer);
/// How it was decided, a sentence each.
[[nodiscard]] std::vector<std::string> answer_legend(const Answer& answer);

}  // namespace nodal::report
