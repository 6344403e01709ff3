// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The parts that a page is put together from.

#include <string>
#include <string_view>

#include "chart/line_chart.h"
#include "report_data.h"

namespace nodal::report {

/// The table of one problem, in a box that scrolls by itself.
[[nodiscard]] std::string table_html(const ProblemReport& problem);
/// The chart of one problem: a still picture, its figures as tables, its data as JSON, and the empty element that
/// report.js draws into. Empty without curves.
[[nodiscard]] std::string chart_html(const ProblemReport& problem, std::size_t index);
/// The chart of its unseen errors. Empty where nothing is held out.
[[nodiscard]] std::string unseen_chart_html(const ProblemReport& problem, std::size_t index);

/// Which optimizer to take: the first section. Empty without an answer.
[[nodiscard]] std::string answer_html(const ReportData& data);

/// Tables of a chart's figures, which open by "Figures as a table".
[[nodiscard]] std::string folded_figures(const std::string& tables);
/// A chart without a script, its title above it, in a box that scrolls by itself, and its figures as a table below.
[[nodiscard]] std::string still_figure(const LineChart& chart, const std::string& id, const std::string& table);

/// Budgets, targets and profiles, as charts and tables. Empty without figures.
[[nodiscard]] std::string convergence_html(const ReportData& data);
/// Profiles over one axis, folded but for seconds.
[[nodiscard]] std::string profiles_html(const Profiles& profiles, const std::vector<ProblemReport>& problems);
/// Seconds or a count.
[[nodiscard]] std::string cost_text(double cost, Axis axis);
/// "12.3 ms [11 ms, 14 ms]", the interval where it has a width; "never".
[[nodiscard]] std::string expected_text(const TargetFigures& target, Axis axis);
/// "14 of 15 [0.70, 0.99]".
[[nodiscard]] std::string success_text(const TargetFigures& target);
/// What qualities of all problems are called; "quality" where they have no name in common.
[[nodiscard]] std::string common_quality_name(const ReportData& data);
/// Which gaps are no targets, and why; empty where all are.
[[nodiscard]] std::string refused_text(const ProblemConvergence& problem);
/// A folded section per optimizer. Empty where nothing is told of any.
[[nodiscard]] std::string optimizers_html(const ReportData& data);

/// Builds, the study as it was read, and how to run it again.
[[nodiscard]] std::string provenance_html(const ReportData& data);

/// Files that the build has put into the program. charts_js comes before every other script but Vega.
[[nodiscard]] std::string_view report_css();
[[nodiscard]] std::string_view charts_js();
[[nodiscard]] std::string_view report_js();
[[nodiscard]] std::string_view tables_js();
[[nodiscard]] std::string_view vega_js();

}  // namespace nodal::report
