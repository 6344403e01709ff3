// SPDX-License-Identifier: GPL-3.0-or-later
#include "unseen_table.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include <nodal/unseen.h>

#include "marked_table.h"

namespace nodal::docs {

namespace {

constexpr int kErrorDigits = 2;

std::optional<double> median(const std::optional<Quartiles>& q) { return q ? std::optional(q->median) : std::nullopt; }

std::vector<std::string> labels_of(const report::ReportData& data) {
  std::vector<std::string> labels;
  for (const report::ProblemReport& problem : data.problems)
    for (const OptimizerRow& row : problem.table.rows)
      if (std::ranges::find(labels, row.label) == labels.end()) labels.push_back(row.label);
  return labels;
}

std::string cell_of(const ProblemTable& table, const std::string& label) {
  const auto row = std::ranges::find(table.rows, label, &OptimizerRow::label);
  if (row == table.rows.end()) return "–";
  const auto unseen = row->findings.find(kUnseenFinding);
  return unseen_cell(median(row->relative_error),
                     unseen == row->findings.end() ? std::nullopt : std::optional(unseen->second.median));
}

}  // namespace

std::string unseen_cell(const std::optional<double>& fitted, const std::optional<double>& unseen) {
  const auto text = [](const std::optional<double>& error) { return error ? figure_text(*error, kErrorDigits) : "–"; };
  return fmt::format("{} / {}", text(fitted), text(unseen));
}

std::string unseen_table(const report::ReportData& data) {
  const std::vector<std::string> labels = labels_of(data);
  std::vector<std::vector<std::string>> rows = {{"scene", "start"}};
  rows[0].insert(rows[0].end(), labels.begin(), labels.end());
  for (const report::ProblemReport& problem : data.problems) {
    const ProblemTable& table = problem.table;
    std::vector<std::string>& row = rows.emplace_back();
    row = {table.reference.label,
           unseen_cell(table.start_relative_error, table.unseen ? table.unseen->start : std::nullopt)};
    for (const std::string& label : labels) row.push_back(cell_of(table, label));
  }
  return markdown_table(rows);
}

}  // namespace nodal::docs
