// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include <nodal/shown.h>

#include "report.h"

namespace nodal::report {

namespace {

constexpr std::array<Axis, 3> kAxes = {Axis::seconds, Axis::evaluations, Axis::work};

// A spreadsheet computes a cell that begins like a formula, quoted or not; with an apostrophe it is text.
std::string harmless(const std::string& text) {
  return !text.empty() && std::string_view("=+-@").find(text[0]) != std::string_view::npos ? "'" + text : text;
}

// Whoever shows the file in a terminal is safe from what a text holds.
std::string quoted(const std::string& label) {
  const std::string text = harmless(printable(label));
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

// Fewest digits that read back to the same double.
std::string exact(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : "";
}

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
  for (const double gap : kTargetGaps) {
    const std::string suffix = "_to_gap_" + gap_text(gap);
    for (const char* count : {"runs", "reached", "success_rate"}) names.push_back(count + suffix);
    for (const Axis axis : kAxes) names.push_back(std::string(to_string(axis)) + suffix);
    for (const Axis axis : kAxes) names.push_back(std::string(to_string(axis)) + "_multiple" + suffix);
  }
  std::vector<std::string> last = findings;
  if (prior) last.insert(last.begin(), "data_quality");
  for (const std::string& figure : last)
    for (const char* part : {"lower", "median", "upper"}) names.push_back(quoted(figure + "_" + part));
  return names;
}

std::vector<std::string> cells_of(const ProblemTable& table, const OptimizerRow& row,
                                  const std::vector<std::string>& findings, bool prior) {
  std::vector<std::string> cells = {quoted(table.reference.label),
                                    quoted(row.label),
                                    quoted(row.use),
                                    row.baseline ? "true" : "false",
                                    std::to_string(row.trials),
                                    std::to_string(row.failed),
                                    std::to_string(row.contaminated),
                                    row.deterministic ? "true" : "false",
                                    std::to_string(row.starts),
                                    exact(table.reference.best_quality),
                                    quoted(table.reference.origin),
                                    table.reference.provisional ? "true" : "false",
                                    exact(table.start_quality),
                                    exact(table.start_relative_error)};
  for (const auto* q : {&row.quality, &row.relative_error, &row.at_bounds, &row.evaluations, &row.factorizations,
                        &row.seconds, &row.work})
    add_quartiles(cells, *q);
  for (const TargetRow& target : row.targets) {
    cells.push_back(std::to_string(target.runs));
    cells.push_back(std::to_string(target.reached));
    cells.push_back(exact(target.success_rate));
    for (const Axis axis : kAxes) cells.push_back(exact(target.median[static_cast<std::size_t>(axis)]));
    for (const Axis axis : kAxes) cells.push_back(exact(target.multiple[static_cast<std::size_t>(axis)]));
  }
  if (prior) add_quartiles(cells, row.data_quality);
  for (const std::string& finding : findings) {
    const auto found = row.findings.find(finding);
    add_quartiles(cells, found == row.findings.end() ? std::nullopt : std::optional(found->second));
  }
  return cells;
}

}  // namespace

std::string summary_csv(const ReportData& data) {
  const std::vector<std::string> findings = finding_names(data);
  const bool prior = has_prior(data);
  std::string text = fmt::format("{}\n", fmt::join(header(findings, prior), ","));
  for (const ProblemReport& problem : data.problems)
    for (const OptimizerRow& row : problem.table.rows)
      text += fmt::format("{}\n", fmt::join(cells_of(problem.table, row, findings, prior), ","));
  return text;
}

}  // namespace nodal::report
