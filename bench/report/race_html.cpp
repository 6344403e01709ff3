// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>

#include "chart/figures_table.h"
#include "chart/svg_chart.h"
#include "page_parts.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

std::string radio(const std::string& id, const char* group, std::string_view value, std::string_view label,
                  bool checked) {
  return fmt::format(R"(<label><input type="radio" name="{}-{}" data-{}="{}"{}> {}</label>)", id, group, group, value,
                     checked ? " checked" : "", escape_html(label));
}

std::string axis_controls(const std::string& id, const std::vector<Axis>& axes) {
  std::string text = "<fieldset><legend>Against</legend>";
  for (const Axis axis : axes) text += radio(id, "axis", to_string(axis), axis_name(axis), axis == axes.front());
  return text + "</fieldset>";
}

std::string height_controls(const ProblemReport& problem, const std::string& id) {
  return "<fieldset><legend>Show</legend>" + radio(id, "height", "error", height_title(problem, Raced::quality), true) +
         radio(id, "height", "gap", height_title(problem, Raced::gap), false) + "</fieldset>";
}

std::string tables_html(const ProblemReport& problem, Raced raced, const std::vector<Axis>& axes) {
  std::string tables;
  for (const Axis axis : axes) tables += figures_table(race_chart(problem, raced, axis));
  return folded_figures(tables);
}

// What a chart is without a script.
std::string still_html(const LineChart& chart, const std::string& id) {
  return fmt::format("<div class=\"still\" tabindex=\"0\" role=\"region\" aria-label=\"Chart: {}\">\n{}</div>\n",
                     escape_html(chart.title), svg_chart(chart, id));
}

// The still picture is what is seen without a script, and printed; report.js puts its own chart in its place.
std::string figure_html(const ProblemReport& problem, Raced raced, const std::string& id, const std::string& controls,
                        const std::string& caption) {
  const std::vector<Axis>& axes = problem.table.axes;
  const LineChart still = race_chart(problem, raced, axes.front());
  return fmt::format(
      "<figure class=\"race\" id=\"{0}\">\n<div class=\"controls\">{1}</div>\n{3}<div class=\"chart\" role=\"img\" "
      "aria-label=\"{2}\"></div>\n<div class=\"keys\" role=\"group\" aria-label=\"Optimizers shown\"></div>\n"
      "<figcaption>{4}<span class=\"scripted\"> Choose an optimizer below the chart to hide or show its "
      "line.</span></figcaption>\n<div class=\"save\"></div>\n{5}<script type=\"application/json\" "
      "class=\"race-data\">{6}</script>\n</figure>\n",
      id, controls, escape_html(still.title), still_html(still, id + "-still"), escape_html(caption),
      tables_html(problem, raced, axes), escape_script(to_json(race_data(problem, raced))));
}

}  // namespace

std::string folded_figures(const std::string& tables) {
  return "<details class=\"figures\"><summary>Figures as a table</summary>\n" + tables + "</details>\n";
}

std::string still_figure(const LineChart& chart, const std::string& id, const std::string& table) {
  return "<figure class=\"lone\">\n<figcaption>" + escape_html(chart.title) + "</figcaption>\n" +
         still_html(chart, id) + table + "</figure>\n";
}

std::string chart_html(const ProblemReport& problem, std::size_t index) {
  if (problem.curves.empty()) return {};
  const std::string id = fmt::format("race-{}", index);
  const bool sampled = std::ranges::any_of(problem.table.rows, [](const OptimizerRow& row) { return row.starts > 1; });
  return figure_html(problem, Raced::quality, id, axis_controls(id, problem.table.axes) + height_controls(problem, id),
                     "Median over trials; the band holds the middle half of them. A dotted line goes on from where an "
                     "optimizer's trials ended." +
                         std::string(sampled && has_gap(problem)
                                         ? " Trials have starts of their own: the gap drawn is 1 at that of repeat 0; "
                                           "tables have each trial's own."
                                         : ""));
}

std::string unseen_chart_html(const ProblemReport& problem, std::size_t index) {
  if (problem.unseen_curves.empty() || !problem.table.unseen) return {};
  const std::string id = fmt::format("unseen-{}", index);
  return "<h3>What is held out</h3>\n" +
         figure_html(
             problem, Raced::unseen, id, axis_controls(id, problem.table.axes),
             fmt::format(
                 "Unseen error of the best point so far: root mean square of the relative errors in "
                 "{}, which no optimizer sees. Median over trials; the band holds the middle half.{}",
                 fmt::join(problem.table.unseen->reported, ", "),
                 problem.table.unseen->chosen_by.empty() ? "" : " Lines go on beyond the points that are reported."));
}

}  // namespace nodal::report
