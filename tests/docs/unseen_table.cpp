// SPDX-License-Identifier: GPL-3.0-or-later
#include "unseen_table.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/show/number_text.h>
#include <nodal/unseen.h>

namespace nodal::docs {

namespace {

constexpr const char* kBegin = "<!-- made from bench/scenes/unseen.toml -->\n";
constexpr const char* kEnd = "<!-- end of what is made -->\n";
constexpr int kDigits = 2;

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

std::size_t begin_of(const std::string& page) {
  const std::size_t begin = page.find(kBegin);
  if (begin == std::string::npos || page.find(kEnd, begin) == std::string::npos)
    throw InputError("the page has no table: no comments say where it begins and ends");
  return begin + std::string_view(kBegin).size();
}

}  // namespace

std::string unseen_cell(const std::optional<double>& fitted, const std::optional<double>& unseen) {
  const auto text = [](const std::optional<double>& error) { return error ? figure_text(*error, kDigits) : "–"; };
  return fmt::format("{} / {}", text(fitted), text(unseen));
}

std::string unseen_table(const report::ReportData& data) {
  const std::vector<std::string> labels = labels_of(data);
  std::string head = "| scene | start |", rule = "|---|---|", body;
  for (const std::string& label : labels) {
    head += " " + label + " |";
    rule += "---|";
  }
  for (const report::ProblemReport& problem : data.problems) {
    const ProblemTable& table = problem.table;
    body += "| " + table.reference.label + " | " +
            unseen_cell(table.start_relative_error, table.unseen ? table.unseen->start : std::nullopt) + " |";
    for (const std::string& label : labels) body += " " + cell_of(table, label) + " |";
    body += "\n";
  }
  return head + "\n" + rule + "\n" + body;
}

std::string with_unseen_table(std::string page, const std::string& table) {
  const std::size_t begin = begin_of(page);
  return page.replace(begin, page.find(kEnd, begin) - begin, table);
}

std::vector<std::vector<std::string>> unseen_rows(const std::string& page) {
  const std::size_t begin = begin_of(page);
  std::istringstream lines(page.substr(begin, page.find(kEnd, begin) - begin));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& cells = rows.emplace_back();
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t bar = std::min(line.find('|', at), line.size());
      const std::size_t first = line.find_first_not_of(' ', at), last = line.find_last_not_of(' ', bar - 1);
      cells.push_back(line.substr(first, last + 1 - first));
      at = bar + 1;
    }
  }
  return rows;
}

}  // namespace nodal::docs
