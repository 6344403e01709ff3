// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "chart/figures_table.h"
#include "convergence_charts.h"
#include "folded_table.h"
#include "page_parts.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

constexpr int kShownDigits = 3;

std::string targets_table(const ProblemConvergence& problem, const std::string& title,
                          const std::function<std::string(const TargetFigures&)>& text) {
  TableRow head = {"optimizer"};
  for (const double gap : kTargetGaps)
    if (std::ranges::find(problem.refused, gap) == problem.refused.end()) head.push_back("to " + gap_text(gap));
  std::vector<TableRow> rows;
  for (const ConvergenceFigures& figures : problem.optimizers) {
    TableRow& row = rows.emplace_back(TableRow{figures.optimizer});
    for (const TargetFigures& target : figures.targets) row.push_back(text(target));
  }
  return folded_table(title, head, rows);
}

std::string areas_table(const ProblemConvergence& problem, std::span<const Axis> counted) {
  TableRow head = {"optimizer"};
  std::vector<Axis> axes;
  for (const Axis axis : counted)
    if (const auto& limits = problem.limits[static_cast<std::size_t>(axis)]) {
      axes.push_back(axis);
      head.push_back(fmt::format("{} {} to {}, gap {} to {}", axis_name(axis), cost_text(limits->from, axis),
                                 cost_text(limits->to, axis), gap_text(limits->largest),
                                 figure_text(limits->smallest, 1)));
    }
  if (axes.empty()) return {};
  std::vector<TableRow> rows;
  for (const ConvergenceFigures& figures : problem.optimizers) {
    TableRow& row = rows.emplace_back(TableRow{figures.optimizer});
    for (const Axis axis : axes) {
      const std::optional<double>& area = figures.area[static_cast<std::size_t>(axis)];
      row.push_back(area ? figure_text(*area, kShownDigits) : "–");
    }
  }
  return folded_table("Area over the convergence curve: 1 is at the smallest gap at once", head, rows);
}

std::string spread_text(const Standing& standing) {
  const auto text = [](const std::optional<double>& value) { return value ? figure_text(*value, 4) : "never"; };
  const Spread& q = standing.quality;
  return q.lower ? fmt::format("{} [{}, {}]", text(q.median), text(q.lower), text(q.upper)) : "never";
}

// What was reached within each budget.
std::string budgets_table(const ReportData& data, const ProblemReport& problem) {
  const Answer& answer = data.answer;
  const auto of = std::ranges::find(answer.problems, problem.table.reference.label, &ProblemAnswer::problem);
  const std::vector<Verdict>& verdicts = of == answer.problems.end() ? answer.verdicts : of->verdicts;
  if (verdicts.empty() || verdicts.front().problems.size() != 1) return {};
  TableRow head = {"optimizer"};
  for (const Verdict& verdict : verdicts) head.push_back(limit_text(verdict.limit, answer.scope));
  std::vector<TableRow> rows;
  for (const OptimizerRow& optimizer : problem.table.rows) {
    TableRow& row = rows.emplace_back(TableRow{optimizer.label});
    for (const Verdict& verdict : verdicts) {
      const auto here = std::ranges::find(verdict.standings, optimizer.label, &Standing::optimizer);
      row.push_back(here == verdict.standings.end() ? "–" : spread_text(*here));
    }
  }
  return folded_table(problem.raced_name() + " within a budget: median [quartiles]", head, rows);
}

std::string attainment(const ReportData& data, std::size_t index) {
  std::string text =
      "<details class=\"attained\"><summary>Attained by a quarter, half and three quarters of the trials</summary>\n";
  for (const Axis axis : data.problems[index].table.axes) {
    const LineChart chart = attainment_chart(data.problems[index], data.convergence[index], axis);
    text += still_figure(chart, fmt::format("attained-{}-{}", index, to_string(axis)),
                         folded_figures(figures_table(chart)));
  }
  return text + "</details>\n";
}

std::string problem_tables(const ReportData& data, std::size_t index) {
  const ProblemConvergence& problem = data.convergence[index];
  const std::vector<Axis>& axes = data.problems[index].table.axes;
  std::string text;
  if (data.convergence.size() > 1) text += "<h3>" + escape_html(problem.problem) + "</h3>\n";
  if (const std::string note = refused_text(problem); !note.empty())
    text += "<p class=\"note\">" + escape_html(note) + "</p>\n";
  text += budgets_table(data, data.problems[index]);
  for (const Axis axis : axes)
    text += targets_table(problem, fmt::format("Expected {} to a gap [95 % interval]", axis_name(axis)),
                          [axis](const TargetFigures& target) { return expected_text(target, axis); });
  text += targets_table(problem, "Success: distinct runs that reached a gap [Wilson's 95 % interval]", success_text);
  return text + areas_table(problem, axes) + attainment(data, index);
}

}  // namespace

std::string cost_text(double cost, Axis axis) { return axis == Axis::seconds ? seconds_text(cost) : count_text(cost); }

std::string expected_text(const TargetFigures& target, Axis axis) {
  const auto a = static_cast<std::size_t>(axis);
  if (!target.expected[a]) return "never";
  std::string text = cost_text(*target.expected[a], axis);
  if (const auto& interval = target.interval[a]; interval && interval->lower != interval->upper)
    text += fmt::format(" [{}, {}]", interval->lower ? cost_text(*interval->lower, axis) : "never",
                        interval->upper ? cost_text(*interval->upper, axis) : "never");
  return text;
}

std::string success_text(const TargetFigures& target) {
  if (!target.success) return "–";
  const statistics::SuccessRate& rate = *target.success;
  return fmt::format("{} of {} [{}, {}]", rate.successes, rate.trials, share_text(rate.lower), share_text(rate.upper));
}

std::string refused_text(const ProblemConvergence& problem) {
  if (problem.refused.empty()) return {};
  if (problem.least_gap >= 1.0) return "No targets: the start can't be told from the best known quality.";
  std::vector<std::string> gaps;
  for (const double gap : problem.refused) gaps.push_back(gap_text(gap));
  return fmt::format(
      "No targets: gap{} {}. The best known quality isn't known well enough: it may be off by a gap of {}.",
      gaps.size() == 1 ? "" : "s", fmt::join(gaps, ", "), figure_text(problem.least_gap, 1));
}

std::string convergence_html(const ReportData& data) {
  if (data.convergence.empty()) return {};
  std::string text = "<section class=\"convergence\">\n<h2>Budgets and targets in figures</h2>\n";
  for (std::size_t i = 0; i < data.convergence.size(); ++i) text += problem_tables(data, i);
  if (!data.profiles.empty()) text += "<h3>Over problems and targets</h3>\n";
  for (const Profiles& profiles : data.profiles) text += profiles_html(profiles, data.problems);
  return text + "</section>\n";
}

}  // namespace nodal::report
