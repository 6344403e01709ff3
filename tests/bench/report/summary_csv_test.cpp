// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <report/report.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "fixture.h"
#include "made_store.h"

namespace nodal::report {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(OptimizersCsv, HasEveryFigureInFullPrecision) {
  const std::vector<std::string> lines = lines_of(optimizers_csv(fixture::make_data()));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(
      lines[0].starts_with("problem,optimizer,use,baseline,trials,failed,contaminated,deterministic,starts,best_known,"
                           "best_known_origin,best_known_provisional,"
                           "start_quality,start_relative_error,quality_lower,quality_median,quality_upper,"))
      << lines[0];
  EXPECT_TRUE(lines[0].ends_with(
      ",work_lower,work_median,work_upper,seconds_area,evaluations_area,work_area,factorizations_area"))
      << lines[0];
  EXPECT_TRUE(lines[1].starts_with(
      "plate,annealing,annealing,true,15,0,0,false,1,0.7376255865,\"multi-start Gauss-Newton, 12 starts agree\",false,"
      "2.304,0.288,0.7496495999999999,0.7504,0.7511503999999999,"))
      << lines[1];
}

// A row per problem, optimizer and target: nothing for never.
TEST(SummaryCsv, IsTidy) {
  const std::vector<std::string> lines = lines_of(summary_csv(fixture::make_data()));
  ASSERT_EQ(lines.size(), 1u + 3u * kTargetGaps.size());
  EXPECT_EQ(lines[0],
            "problem,optimizer,use,baseline,gap,refused,trials,runs,reached,success_rate,success_rate_lower,"
            "success_rate_upper,seconds_expected,seconds_expected_lower,seconds_expected_upper,seconds_median,"
            "seconds_multiple,evaluations_expected,evaluations_expected_lower,evaluations_expected_upper,"
            "evaluations_median,evaluations_multiple,work_expected,work_expected_lower,work_expected_upper,work_median,"
            "work_multiple,factorizations_expected,factorizations_expected_lower,factorizations_expected_upper,"
            "factorizations_median,factorizations_multiple");
  EXPECT_EQ(
      lines[10],
      "plate,ceres-levenberg-marquardt,ceres-levenberg-marquardt,false,0.01,false,3,1,1,1,,,,,,0.0006,333.3,,,,0.6,"
      ",,,,0.06,,,,,,");
  EXPECT_EQ(lines[24], "plate,random-search,random-search,false,1e-08,false,15,15,0,0,,,,,,,,,,,,,,,,,,,,,,");
}

// Expected times by hand: 0.5 ms, 1 ms and never in 500 ms; 5, 10 and never in 5,000 evaluations.
TEST(SummaryCsv, HasExpectedTimesAndIntervals) {
  MadeStore made;
  made.add("plate", "a", 0, {{5, 1.0}});
  made.add("plate", "a", 1, {{10, 1.0}});
  made.add("plate", "a", 2, {{10, 3.0}});
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const std::vector<std::string> lines = lines_of(summary_csv(data));
  ASSERT_EQ(lines.size(), 1u + kTargetGaps.size());
  const statistics::SuccessRate rate = *statistics::success_rate(2, 3);
  EXPECT_TRUE(lines[1].starts_with("plate,a,a,false,0.1,false,3,3,2,0.6666666666666666," +
                                   fmt::format("{}", rate.lower) + "," + fmt::format("{}", rate.upper) + ",0.25075,"))
      << lines[1];
  EXPECT_NE(lines[1].find(",2507.5,"), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find(",0.001,"), std::string::npos) << lines[1];  // the median of 0.5 ms, 1 ms and never
}

// What nobody knows well enough has no figures, but a line.
TEST(SummaryCsv, RefusedTargetsAreMarked) {
  ReportData data = fixture::make_data();
  ProblemConvergence& found = data.convergence.emplace_back();
  found.problem = "plate";
  found.refused = {1e-8};
  found.optimizers.resize(1);
  found.optimizers[0].optimizer = "annealing";
  for (const double gap : kTargetGaps)
    if (gap > 1e-8) found.optimizers[0].targets.push_back({gap, {}, {}, {}});
  const std::vector<std::string> lines = lines_of(summary_csv(data));
  EXPECT_EQ(lines[8], "plate,annealing,annealing,true,1e-08,true,15,,,,,,,,,,,,,,,,,,,,,,,,,");
  EXPECT_TRUE(lines[7].starts_with("plate,annealing,annealing,true,1e-07,false,15,15,0,0,")) << lines[7];
}

TEST(BudgetsCsv, HasARowForEachBudgetAndOptimizer) {
  MadeStore made;
  for (int r = 0; r < 8; ++r) {
    made.add("plate", "b", r, {{5, 3.0 + 0.11 * r}}, 4.0 + r);
    made.add("plate", "a", r, {{5, 2.0 + 0.1 * r}}, 4.0 + r);
  }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const std::vector<std::string> lines = lines_of(budgets_csv(collect(stores, Registry())));
  ASSERT_EQ(lines.size(), 1u + 2u * 7u);
  EXPECT_EQ(lines[0],
            "problem,optimizer,axis,budget,trials,observations,disturbed,quality_lower,quality_median,quality_upper,"
            "median_lower,median_upper,rank,friedman_p,relation,test,pairs,p,effect");
  EXPECT_TRUE(lines[1].starts_with("plate,a,seconds,0.001,8,8,0,2.17")) << lines[1];
  EXPECT_TRUE(lines[1].ends_with(",2,2.7,1,,first,,,,")) << lines[1];
  EXPECT_TRUE(lines[2].ends_with(",3,3.77,2,,told,wilcoxon,8,0.0078125,1")) << lines[2];
  EXPECT_TRUE(lines[14].starts_with("plate,b,evaluations,,8,8,0,")) << lines[14];
}

TEST(OptimizersCsv, EveryLineHasAsManyFieldsAsTheHeader) {
  ReportData data = fixture::make_data();
  data.problems[0].table.reference.origin = "no commas";
  const std::vector<std::string> lines = lines_of(optimizers_csv(data));
  for (const std::string& line : lines) EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ','));
}

TEST(OptimizersCsv, QuotesLabelsThatNeedIt) {
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "a \"hot\", slow start";
  EXPECT_NE(optimizers_csv(data).find("\nplate,\"a \"\"hot\"\", slow start\",annealing,true,"), std::string::npos);
}

// A spreadsheet computes what begins like a formula, quoted or not.
TEST(OptimizersCsv, HoldsNoFormulas) {
  for (const char* label : {"=cmd|' /C calc'!A0", "@SUM(1+1)", "-2+3", "+1"}) {
    ReportData data = fixture::make_data();
    ProblemTable& table = data.problems[0].table;
    table.reference.label = table.reference.origin = table.rows[0].label = table.rows[0].use = label;
    const std::string shown = std::string("'") + label;
    const std::string text = optimizers_csv(data);
    EXPECT_NE(text.find("\n" + shown + "," + shown + "," + shown + ",true,"), std::string::npos) << text;
    EXPECT_NE(text.find("," + shown + ",false,"), std::string::npos) << text;  // the origin
  }
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "a=b-c";
  EXPECT_NE(optimizers_csv(data).find("\nplate,a=b-c,"), std::string::npos);
}

// One line a row, and nothing that a terminal obeys.
TEST(OptimizersCsv, HoldsNoControlCharacters) {
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "\ta\r\n\x1B[31m\"\u202E";
  const std::string text = optimizers_csv(data);
  EXPECT_NE(text.find("\nplate,\"\\ta\\r\\n\\u001b[31m\"\"\\u202e\",annealing,"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; }), 0);
}

// A problem that lacks another's finding has empty cells.
TEST(OptimizersCsv, HasThreeColumnsForEachFinding) {
  ReportData data = fixture::make_data();
  data.problems.push_back(fixture::make_problem());
  data.problems[0].findings = {{.name = "half_life", .title = "half-life"}};
  data.problems[0].table.rows[0].findings["half_life"] = {1.5, 2.5, 3.5};
  std::istringstream lines(optimizers_csv(data));
  std::string header, first, second;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_TRUE(header.ends_with(",half_life_lower,half_life_median,half_life_upper")) << header;
  EXPECT_TRUE(first.ends_with(",1.5,2.5,3.5")) << first;
  EXPECT_TRUE(second.ends_with(",,,")) << second;
  const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
  EXPECT_EQ(commas(first), commas(second));
}

}  // namespace
}  // namespace nodal::report
