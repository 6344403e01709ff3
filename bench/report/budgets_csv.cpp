// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv_cells.h"
#include "report.h"

namespace nodal::report {

namespace {

using csv::exact;

const char* to_string(Relation relation) {
  switch (relation) {
    case Relation::first:
      return "first";
    case Relation::equal:
      return "equal";
    case Relation::untold:
      return "untold";
    case Relation::contrary:
      return "contrary";
    case Relation::untested:
      return "untested";
    case Relation::told:
      return "told";
  }
  return "";
}

const char* to_string(PairTest test) {
  switch (test) {
    case PairTest::none:
      return "";
    case PairTest::wilcoxon:
      return "wilcoxon";
    case PairTest::mann_whitney:
      return "mann-whitney";
  }
  return "";
}

csv::Cells cells_of(const std::string& problem, const Verdict& verdict, const Standing& standing) {
  const bool one = verdict.problems.size() == 1;
  return {csv::quoted(problem),
          csv::quoted(standing.optimizer),
          std::string(nodal::to_string(verdict.limit.axis)),
          exact(verdict.limit.cost),
          std::to_string(standing.trials),
          std::to_string(standing.observations),
          std::to_string(standing.disturbed),
          exact(standing.quality.lower),
          exact(standing.quality.median),
          exact(standing.quality.upper),
          exact(standing.median_interval.lower),
          exact(standing.median_interval.upper),
          exact(standing.rank),
          one ? "" : exact(verdict.friedman_p),
          verdict.nobody ? "" : to_string(standing.relation),
          to_string(standing.test),
          standing.test == PairTest::none ? "" : std::to_string(standing.pairs),
          exact(standing.p),
          exact(standing.effect)};
}

void add_rows(const std::string& problem, const std::vector<Verdict>& verdicts, std::string& text) {
  for (const Verdict& verdict : verdicts)
    for (const Standing& standing : verdict.standings) text += csv::line(cells_of(problem, verdict, standing));
}

}  // namespace

std::string budgets_csv(const ReportData& data) {
  std::string text = csv::line({"problem", "optimizer", "axis", "budget", "trials", "observations", "disturbed",
                                "quality_lower", "quality_median", "quality_upper", "median_lower", "median_upper",
                                "rank", "friedman_p", "relation", "test", "pairs", "p", "effect"});
  const Answer& answer = data.answer;
  if (answer.empty()) return text;
  for (const ProblemAnswer& of : answer.problems) add_rows(of.problem, of.verdicts, text);
  const std::vector<std::string>& problems = answer.verdicts.front().problems;
  add_rows(problems.size() == 1 ? problems.front() : "", answer.verdicts, text);
  return text;
}

}  // namespace nodal::report
