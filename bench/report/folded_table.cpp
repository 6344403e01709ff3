// SPDX-License-Identifier: GPL-3.0-or-later
#include "folded_table.h"

#include <fmt/format.h>

#include <nodal/show/html.h>

namespace nodal::report {

std::string folded_table(const std::string& title, const TableRow& head, const std::vector<TableRow>& rows) {
  std::string text = "<details><summary>" + escape_html(title) +
                     "</summary>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                     escape_html(title) + "\"><table><thead><tr>";
  for (std::size_t c = 0; c < head.size(); ++c)
    text += fmt::format("<th scope=\"col\"{}>{}</th>", c == 0 ? " class=\"label\"" : "", escape_html(head[c]));
  text += "</tr></thead><tbody>\n";
  for (const TableRow& row : rows) {
    text += "<tr><th scope=\"row\">" + escape_html(row.front()) + "</th>";
    for (std::size_t c = 1; c < row.size(); ++c)
      text += fmt::format("<td{}>{}</td>", row[c] == "never" ? " class=\"never\"" : "", escape_html(row[c]));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div></details>\n";
}

std::string share_text(double share) { return fmt::format("{:.2f}", share); }

}  // namespace nodal::report
