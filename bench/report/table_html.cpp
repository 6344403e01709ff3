// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/html.h>

#include "page_parts.h"
#include "table.h"

namespace nodal::report {

namespace {

// How far a figure is from the best of its column, in steps that can be told apart at a glance. What is between 2 and
// 10 times has no colour.
constexpr double kBest = 1.005, kNear = 1.1, kWithin = 2.0, kBeyond = 10.0;

std::string_view grade(double value, double best) {
  if (!(best > 0.0)) return value == best ? "best" : "";
  const double ratio = value / best;
  return ratio <= kBest     ? "best"
         : ratio <= kNear   ? "near"
         : ratio <= kWithin ? "within2"
         : ratio > kBeyond  ? "beyond10"
                            : "";
}

std::optional<double> best_of(const Table& table, std::size_t column) {
  std::optional<double> best;
  std::size_t known = 0;
  for (const auto& row : table.values)
    if (row[column]) {
      best = best ? std::min(*best, *row[column]) : *row[column];
      ++known;
    }
  return known > 1 ? best : std::nullopt;
}

std::string head(const std::vector<Column>& columns) {
  std::string text = "<thead><tr>";
  for (const Column& c : columns)
    text += fmt::format(R"(<th scope="col"{} title="{}">{}{}{}</th>)", c.left ? " class=\"label\"" : "",
                        escape_html(c.help), escape_html(c.title), c.title.empty() || c.subtitle.empty() ? "" : "<br>",
                        escape_html(c.subtitle));
  return text + "</tr></thead>\n";
}

// On a phone nothing hovers.
std::string column_words(const std::vector<Column>& columns) {
  std::string text = "<details class=\"columns\"><summary>What the columns say</summary>\n<dl>\n";
  for (const Column& c : columns) {
    std::string name = c.title + (c.title.ends_with('-') || c.title.empty() ? "" : " ") + c.subtitle;
    if (const std::size_t hyphen = name.find('-'); c.title.ends_with('-')) name.erase(hyphen, 1);
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(name), escape_html(c.help));
  }
  return text +
         "</dl>\n<p class=\"note\">Green: within 0.5 %, 10 % or a factor of 2 of the best of the column, the "
         "darker the nearer; the best is bold. Red: more than 10 times the best.</p></details>\n";
}

std::string number_attribute(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format(" data-v=\"{:.6g}\"", *value) : "";
}

struct Cell {
  const Column& column;
  const std::string& text;
  std::optional<double> value, best;
};

std::string cell_html(const Cell& cell) {
  if (cell.column.left) return fmt::format(R"(<th scope="row">{}</th>)", escape_html(cell.text));
  std::string_view style = cell.text.ends_with("never") ? "never" : "";
  if (cell.column.compared && cell.value && cell.best) style = grade(*cell.value, *cell.best);
  return fmt::format("<td{}{}>{}</td>", style.empty() ? "" : fmt::format(" class=\"{}\"", style),
                     number_attribute(cell.value), escape_html(cell.text));
}

std::string body(const Table& table, const ProblemReport& problem) {
  std::vector<std::optional<double>> best;
  for (std::size_t c = 0; c < table.columns.size(); ++c) best.push_back(best_of(table, c));
  std::string text;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto row = std::ranges::find(problem.table.rows, table.optimizers[r], &OptimizerRow::label);
    text += row != problem.table.rows.end() && row->baseline ? "<tr class=\"baseline\">" : "<tr>";
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += cell_html({table.columns[c], table.rows[r][c], table.values[r][c], best[c]});
    text += "</tr>\n";
  }
  return text;
}

}  // namespace

std::string table_html(const ProblemReport& problem) {
  const Table table = make_text_table(problem);
  const std::string caption = "Results on " + escape_html(problem.table.reference.label);
  std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + caption +
                     "\"><table class=\"sortable\">\n<caption class=\"unseen-text\">" + caption + "</caption>\n" +
                     head(table.columns) + "<tbody>\n" + body(table, problem) + "</tbody></table></div>\n" +
                     column_words(table.columns);
  for (const std::string& note : table.notes) text += "<p class=\"note\">" + escape_html(note) + "</p>\n";
  return text;
}

}  // namespace nodal::report
