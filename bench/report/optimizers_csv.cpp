// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "csv_cells.h"
#include "report.h"

namespace nodal::report {

namespace {

using csv::Cells;
using csv::exact;
using csv::quoted;

void add_quartiles(std::vector<std::string>& cells, const std::optional<Quartiles>& q) {
  cells.push_back(q ? exact(q->lower) : "");
  cells.push_back(q ? exact(q->median) : "");
  cells.push_back(q ? exact(q->upper) : "");
}

// Of all problems, each name once.
std::vector<std::string> finding_names(const ReportData& data) {
  std::vector<std::string> names;
  for (const ProblemReport& problem : data.problems)
    for (const FindingDescription& finding : problem.findings)
      if (std::ranges::find(names, finding.name) == names.end()) names.push_back(finding.name);
  return names;
}

bool has_prior(const ReportData& data) {
  return std::ranges::any_of(data.problems, [](const ProblemReport& problem) { return problem.table.has_prior; });
}

std::vector<std::string> header(const std::vector<std::string>& findings, bool prior) {
  std::vector<std::string> names = {"problem",
                                    "optimizer",
                                    "use",
                                    "baseline",
                                    "trials",
                                    "failed",
                                    "contaminated",
                                    "deterministic",
                                    "starts",
                                    "best_known",
                                    "best_known_origin",
                                    "best_known_provisional",
                                    "start_quality",
                                    "start_relative_error"};
  for (const char* figure :
       {"quality", "relative_error", "at_bounds", "evaluations", "factorizations", "seconds", "work"})
    for (const char* part : {"lower", "median", "upper"}) names.push_back(fmt::format("{}_{}", figure, part));
  for (const Axis axis : kAxes) names.push_back(std::string(to_string(axis)) + "_area");
  std::vector<std::string> last = findings;
  if (prior) last.insert(last.begin(), "data_quality");
  for (const std::string& figure : last)
    for (const char* part : {"lower", "median", "upper"}) names.push_back(quoted(figure + "_" + part));
  return names;
}

std::vector<std::string> cells_of(const ProblemTable& table, const OptimizerRow& row, const ConvergenceFigures* figures,
                                  const std::vector<std::string>& findings, bool prior) {
  std::vector<std::string> cells = {quoted(table.reference.label),
                                    quoted(row.label),
                                    quoted(row.use),
                                    csv::flag(row.baseline),
                                    std::to_string(row.trials),
                                    std::to_string(row.failed),
                                    std::to_string(row.contaminated),
                                    csv::flag(row.deterministic),
                                    std::to_string(row.starts),
                                    exact(table.reference.best_quality),
                                    quoted(table.reference.origin),
                                    csv::flag(table.reference.provisional),
                                    exact(table.start_quality),
                                    exact(table.start_relative_error)};
  for (const auto* q : {&row.quality, &row.relative_error, &row.at_bounds, &row.evaluations, &row.factorizations,
                        &row.seconds, &row.work})
    add_quartiles(cells, *q);
  for (const Axis axis : kAxes) cells.push_back(figures ? exact(figures->area[static_cast<std::size_t>(axis)]) : "");
  if (prior) add_quartiles(cells, row.data_quality);
  for (const std::string& finding : findings) {
    const auto found = row.findings.find(finding);
    add_quartiles(cells, found == row.findings.end() ? std::nullopt : std::optional(found->second));
  }
  return cells;
}

}  // namespace

std::string optimizers_csv(const ReportData& data) {
  const std::vector<std::string> findings = finding_names(data);
  const bool prior = has_prior(data);
  std::string text = csv::line(header(findings, prior));
  for (const ProblemReport& problem : data.problems)
    for (const OptimizerRow& row : problem.table.rows) {
      const ConvergenceFigures* figures = data.figures_of(problem.table.reference.label, row.label);
      text += csv::line(cells_of(problem.table, row, figures, findings, prior));
    }
  return text;
}

}  // namespace nodal::report
