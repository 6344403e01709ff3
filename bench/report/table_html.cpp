// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/html.h>

#include "page_parts.h"
#include "table.h"

namespace nodal::report {

namespace {

std::string head(const std::vector<Column>& columns) {
  std::string text = "<thead><tr>";
  for (const Column& c : columns)
    text += fmt::format(R"(<th scope="col"{} title="{}">{}<br>{}</th>)", c.left ? " class=\"label\"" : "",
                        escape_html(c.help), escape_html(c.title), escape_html(c.subtitle));
  return text + "</tr></thead>\n";
}

std::string body_row(const std::vector<Column>& columns, const std::vector<std::string>& cells, bool baseline) {
  std::string text = baseline ? "<tr class=\"baseline\">" : "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c)
    text += columns[c].left ? fmt::format(R"(<th scope="row">{}</th>)", escape_html(cells[c]))
                            : fmt::format("<td{}>{}</td>", cells[c].ends_with("never") ? " class=\"never\"" : "",
                                          escape_html(cells[c]));
  return text + "</tr>\n";
}

}  // namespace

std::string table_html(const ProblemReport& problem) {
  const Table table = make_text_table(problem);
  std::string text = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\"><table>\n" +
                     head(table.columns) + "<tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto row = std::ranges::find(problem.table.rows, table.optimizers[r], &OptimizerRow::label);
    text += body_row(table.columns, table.rows[r], row != problem.table.rows.end() && row->baseline);
  }
  text += "</tbody></table></div>\n";
  for (const std::string& note : table.notes) text += "<p class=\"note\">" + escape_html(note) + "</p>\n";
  return text;
}

}  // namespace nodal::report
