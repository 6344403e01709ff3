// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include <nodal/shown.h>

#include "left_out.h"
#include "report.h"
#include "table.h"

namespace nodal::report {

namespace {

constexpr std::size_t kSeparation = 2;

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::size_t used = display_width(text);
  const std::string space(width > used ? width - used : 0, ' ');
  return left ? text + space : space + text;
}

std::vector<std::size_t> column_widths(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t width = std::max(display_width(table.columns[c].title), display_width(table.columns[c].subtitle));
    for (const auto& row : table.rows) width = std::max(width, display_width(row[c]));
    widths.push_back(width);
  }
  return widths;
}

std::string line(const Table& table, const std::vector<std::size_t>& widths, const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t c = 0; c < cells.size(); ++c)
    text += std::string(c == 0 ? 0 : kSeparation, ' ') + padded(cells[c], widths[c], table.columns[c].left);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

void remove_column(Table& table, std::size_t column) {
  const auto at = static_cast<std::ptrdiff_t>(column);
  table.columns.erase(table.columns.begin() + at);
  for (auto& row : table.rows) row.erase(row.begin() + at);
}

// Leaves out columns, highest rank first, until the table fits; returns their names.
std::vector<std::string> fit(Table& table, std::size_t width) {
  std::vector<std::string> left_out;
  for (;;) {
    const std::vector<std::size_t> widths = column_widths(table);
    const std::size_t total = std::accumulate(widths.begin(), widths.end(), kSeparation * (widths.size() - 1));
    const auto next = std::ranges::max_element(table.columns, {}, &Column::rank);
    if (total <= width || next->rank == 0) return left_out;
    left_out.push_back(next->name);
    remove_column(table, static_cast<std::size_t>(next - table.columns.begin()));
  }
}

std::string problem_block(const ProblemReport& problem, std::size_t width) {
  Table table = make_text_table(problem);
  for (auto& row : table.rows)
    for (std::string& cell : row) cell = printable(cell);
  const std::vector<std::string> left_out = fit(table, width);
  const std::vector<std::size_t> widths = column_widths(table);
  std::vector<std::string> titles, subtitles;
  for (const Column& column : table.columns) {
    titles.push_back(column.title);
    subtitles.push_back(column.subtitle);
  }
  std::string text = printable(problem.table.reference.label + ": " + describe_reference(problem)) + "\n\n";
  text += line(table, widths, titles) + line(table, widths, subtitles);
  for (const auto& row : table.rows) text += line(table, widths, row);
  for (const std::string& note : table.notes) text += printable(note) + "\n";
  if (!left_out.empty()) text += fmt::format("(left out to fit {} columns: {})\n", width, fmt::join(left_out, ", "));
  return text + "\n";
}

}  // namespace

std::string console_table(const ReportData& data, std::size_t width) {
  std::string text;
  for (const ProblemReport& problem : data.problems) text += problem_block(problem, width);
  for (const std::string& line : left_out_lines(data.left_out)) text += printable("Left out: " + line) + "\n";
  for (const FailedTrial& trial : data.failed)
    text += printable(fmt::format("Failed: {} on {}, repeat {}, {}: {}", trial.optimizer, trial.problem, trial.repeat,
                                  to_string(trial.end), trial.reason)) +
            "\n";
  for (const std::string& sentence : table_legend(data.problems)) text += sentence + "\n";
  return text;
}

}  // namespace nodal::report
