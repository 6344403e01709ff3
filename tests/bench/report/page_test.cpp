// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <report/page_parts.h>
#include <report/report.h>

#include <regex>

#include "../../support/count.h"
#include "fixture.h"

namespace nodal::report {
namespace {

constexpr const char* kHostile = "</script><img src=x onerror=alert(1)>&\"'";

using toy::count;

TEST(Page, LoadsNothingFromOutside) {
  ReportData data = fixture::make_data();
  const std::string page = report_html(data);
  // Namespaces of SVG inside the scripts are names, not addresses that are loaded.
  const std::regex loads(
      R"((src|href|srcset|action)\s*=\s*["']?\s*(https?:)?//|url\(\s*["']?\s*(https?:)?//|@import|<link|<iframe)");
  const std::string own = page.substr(0, page.find("<script>\n"));
  EXPECT_FALSE(std::regex_search(own, loads));
  for (const std::string_view script : {charts_js(), report_js()})
    EXPECT_FALSE(std::regex_search(std::string(script), loads));
  EXPECT_EQ(count(page, "<script src"), 0u);
}

TEST(Page, LabelsCannotBreakOut) {
  ReportData data = fixture::make_data();
  ProblemReport& problem = data.problems[0];
  data.study_name = data.study_text = problem.table.reference.label = problem.table.reference.origin = kHostile;
  problem.table.rows[0].label = problem.curves[0].optimizer = kHostile;
  data.warnings = {kHostile};
  data.failed[0].reason = kHostile;
  data.left_out[0].reason = kHostile;
  data.builds[0].set("revision", kHostile);
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "<img"), 0u);
  // Two scripts and one block of data: what opens is what we opened.
  EXPECT_EQ(count(page, "</script>"), 3u);
  EXPECT_GE(count(page, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&amp;&quot;&#39;"), 6u);
}

TEST(Page, ShowsTheRowsOfTheConsoleTable) {
  const std::string page = report_html(fixture::make_data());
  for (const char* cell : {">0.09220</td>", ">333×</td>", "<td class=\"never\">never</td>", ">14 of 15</td>",
                           ">det. 3</td>", "<th scope=\"row\">annealing (baseline)</th>"})
    EXPECT_NE(page.find(cell), std::string::npos) << cell;
}

// Errors 0.0938, 0.09220 and 0.2811; times to gap 0.1 of 12.3 ms and 0.5 ms.
TEST(Page, ColoursFiguresByHowNearTheBestTheyAre) {
  const std::string page = report_html(fixture::make_data());
  EXPECT_NE(page.find("<td class=\"near\" data-v=\"0.0938\">0.09380</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"best\" data-v=\"0.0922032\">0.09220</td>"), std::string::npos);
  EXPECT_NE(page.find("<td data-v=\"0.2811\">0.2811</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"beyond10\" data-v=\"0.0123\">12.3 ms</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"best\" data-v=\"0.0005\">500 µs</td>"), std::string::npos);
}

TEST(Page, HasItsChartsWithoutAScript) {
  ReportData data = fixture::make_data();
  const std::string figure = chart_html(data.problems[0], 0);
  EXPECT_EQ(count(figure, "class=\"curve\""), 3u);
  EXPECT_EQ(count(figure, "role=\"img\" aria-labelledby=\"race-0-still-title race-0-still-desc\""), 1u);
  EXPECT_NE(figure.find("lowest first: ceres-levenberg-marquardt 0.0922, annealing 0.0938, random-search 0.281."),
            std::string::npos);
  EXPECT_EQ(count(figure, "<table class=\"figures\">"), 3u);  // against time, evaluations, flops
}

TEST(Page, OffersFactorizationsWhereThereAreAny) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(count(report_html(data), "data-axis=\"factorizations\""), 0u);
  data.problems[0].table.axes = {Axis::seconds, Axis::factorizations};
  for (OptimizerCurves& curves : data.problems[0].curves) curves.by_axis[3] = curves.by_axis[1];
  EXPECT_EQ(count(report_html(data), "data-axis=\"factorizations\""), 1u);
}

// A picture first, then how the problem was made; of what they need each text once.
TEST(Page, PlacesPartsAndWhatTheyNeed) {
  ReportData data = fixture::make_data();
  data.problems.push_back(data.problems[0]);
  data.problems[1].table.reference.label = "second";
  for (const char* label : {"plate", "second"}) data.pictures[label] = {"<b>drawn</b>", ".drawn { }\n", ""};
  data.problems[0].details = {"<i>made</i>", ".made { }\n", "run(made);\n"};
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "<b>drawn</b>"), 2u);
  EXPECT_EQ(count(page, ".drawn { }"), 1u);
  EXPECT_EQ(count(page, ".made { }"), 1u);
  EXPECT_LT(page.find("<b>drawn</b>"), page.find("<i>made</i>"));
  EXPECT_LT(page.find(charts_js()), page.find("run(made);"));
  EXPECT_LT(page.find("run(made);"), page.find("</body>"));
}

TEST(Page, HasTheChartsScriptForAPartEvenWithoutARace) {
  ReportData data = fixture::make_data();
  data.problems[0].curves.clear();
  data.problems[0].details = {"<i>made</i>", "", "run(made);\n"};
  const std::string page = report_html(data);
  EXPECT_NE(page.find(charts_js()), std::string::npos);
  EXPECT_NE(page.find("run(made);"), std::string::npos);
  data.problems[0].details.html.clear();  // no part, nothing that it needs
  EXPECT_EQ(count(report_html(data), "<script"), 0u);
}

TEST(Page, WithoutCurvesItHasNeitherChartNorScript) {
  ReportData data = fixture::make_data();
  data.problems[0].curves.clear();
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_LT(page.size(), 20'000u);  // Vega alone is 450 kB
}

TEST(Page, OffersWorkOnlyWhereTrialsAreToldApartByIt) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(count(report_html(data), "data-axis=\"work\""), 1u);
  data.problems[0].table.axes = {Axis::seconds, Axis::evaluations};
  EXPECT_EQ(count(report_html(data), "data-axis=\"work\""), 0u);
}

TEST(Page, DrawsUnseenErrorsInAChartOfTheirOwn) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(count(report_html(data), "figure class=\"race\""), 1u);
  ProblemReport& problem = data.problems[0];
  problem.unseen_curves = {problem.curves[0]};
  problem.table.unseen = UnseenSummary{{"bend-x", "<b>"}, {}, 0.284};
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "figure class=\"race\""), 2u);
  EXPECT_EQ(count(page, "\"title\":\"unseen error\""), 1u);
  EXPECT_EQ(count(page, "in bend-x, &lt;b&gt;, which no optimizer sees"), 1u);
  EXPECT_EQ(count(unseen_chart_html(problem, 0), "data-height"), 0u);  // no gap to speak of
}

TEST(Page, NeverWritesWhatIsNoNumber) {
  ReportData data = fixture::make_data();
  data.problems[0].curves[0].by_axis[0][0].quality.upper = std::numeric_limits<double>::infinity();
  data.problems[0].curves[0].by_axis[0][1].position = 0.0;
  EXPECT_NO_THROW((void)report_html(data));
  EXPECT_EQ(count(chart_html(data.problems[0], 0), "null"), 0u);
}

TEST(Page, SaysHowToRunTheStudyAgain) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(report_html(data).find("To run it again"), std::string::npos);  // of several studies: which?
  data.run_again = {
      "plate.toml", {{"folder/common.toml", "repeats = 3 # <b>"}}, {"study.seed=3", "problem.label='a b'"}};
  const std::string page = report_html(data);
  EXPECT_NE(page.find("nodal compare plate.toml --set study.seed=3 --set &#39;problem.label=&#39;\\&#39;&#39;a "
                      "b&#39;\\&#39;&#39;&#39;</pre>"),
            std::string::npos);
  EXPECT_NE(page.find("It includes common.toml"), std::string::npos);
  EXPECT_NE(page.find("repeats = 3 # &lt;b&gt;"), std::string::npos);
}

}  // namespace
}  // namespace nodal::report
