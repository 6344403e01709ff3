// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures_table.h"

#include <cmath>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "ticks.h"

namespace nodal::report {

namespace {

constexpr std::size_t kMostColumns = 8;
constexpr int kFigures = 3;  // as many as a chart can be read to

std::string cell(const ChartLine& line, double x, const LineChart& chart) {
  const std::optional<ChartPoint> p = point_at(line, x, chart.x, chart.y);
  if (!p) return "<td>–</td>";
  if (!line.band || p->lower == p->upper) return fmt::format("<td>{}</td>", figure_text(p->y, kFigures));
  return fmt::format("<td>{}<br><small>{} to {}</small></td>", figure_text(p->y, kFigures),
                     figure_text(p->lower, kFigures), std::isfinite(p->upper) ? figure_text(p->upper, kFigures) : "–");
}

}  // namespace

std::string figures_table(const LineChart& all) {
  const LineChart chart = drawable(all);
  const std::vector<double> columns = ticks(*chart.x.limits, chart.x.scale, kMostColumns);
  std::string text = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Figures: {0}\"><table class=\"figures\">"
      "<caption>{0}</caption><thead><tr><th scope=\"col\" class=\"label\">{1}</th>",
      escape_html(chart.title), escape_html(chart.x.title));
  for (const double x : columns) text += fmt::format("<th scope=\"col\">{}</th>", tick_text(x, chart.x.seconds));
  text += "</tr></thead><tbody>\n";
  for (const ChartLine& line : chart.lines) {
    text += "<tr><th scope=\"row\">" + escape_html(line.label) + "</th>";
    for (const double x : columns) text += cell(line, x, chart);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace nodal::report
