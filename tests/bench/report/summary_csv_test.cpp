// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <report/report.h>

#include <algorithm>
#include <sstream>

#include "fixture.h"

namespace nodal::report {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SummaryCsv, HasEveryFigureInFullPrecisionAndNothingForNever) {
  const std::vector<std::string> lines = lines_of(summary_csv(fixture::make_data()));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(
      lines[0].starts_with("problem,optimizer,use,baseline,trials,failed,contaminated,deterministic,starts,best_known,"
                           "best_known_origin,best_known_provisional,"
                           "start_quality,start_relative_error,quality_lower,quality_median,quality_upper,"))
      << lines[0];
  EXPECT_TRUE(
      lines[0].ends_with(",runs_to_gap_1e-8,reached_to_gap_1e-8,success_rate_to_gap_1e-8,seconds_to_gap_1e-8,"
                         "evaluations_to_gap_1e-8,work_to_gap_1e-8,"
                         "seconds_multiple_to_gap_1e-8,evaluations_multiple_to_gap_1e-8,work_multiple_to_gap_1e-8"))
      << lines[0];
  EXPECT_TRUE(lines[1].starts_with(
      "plate,annealing,annealing,true,15,0,0,false,1,0.7376255865,\"multi-start Gauss-Newton, 12 starts agree\",false,"
      "2.304,0.288,0.7496495999999999,0.7504,0.7511503999999999,"))
      << lines[1];
  EXPECT_NE(lines[2].find(",1,1,1,0.0006,0.6,0.06,333.3,,,"), std::string::npos) << lines[2];
  EXPECT_TRUE(lines[3].ends_with(",15,0,0,,,,,,,15,0,0,,,,,,")) << lines[3];
}

TEST(SummaryCsv, EveryLineHasAsManyFieldsAsTheHeader) {
  ReportData data = fixture::make_data();
  data.problems[0].table.reference.origin = "no commas";
  const std::vector<std::string> lines = lines_of(summary_csv(data));
  for (const std::string& line : lines) EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ','));
}

TEST(SummaryCsv, QuotesLabelsThatNeedIt) {
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "a \"hot\", slow start";
  EXPECT_NE(summary_csv(data).find("\nplate,\"a \"\"hot\"\", slow start\",annealing,true,"), std::string::npos);
}

// A spreadsheet computes what begins like a formula, quoted or not.
TEST(SummaryCsv, HoldsNoFormulas) {
  for (const char* label : {"=cmd|' /C calc'!A0", "@SUM(1+1)", "-2+3", "+1"}) {
    ReportData data = fixture::make_data();
    ProblemTable& table = data.problems[0].table;
    table.reference.label = table.reference.origin = table.rows[0].label = table.rows[0].use = label;
    const std::string shown = std::string("'") + label;
    const std::string text = summary_csv(data);
    EXPECT_NE(text.find("\n" + shown + "," + shown + "," + shown + ",true,"), std::string::npos) << text;
    EXPECT_NE(text.find("," + shown + ",false,"), std::string::npos) << text;  // the origin
  }
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "a=b-c";
  EXPECT_NE(summary_csv(data).find("\nplate,a=b-c,"), std::string::npos);
}

// One line a row, and nothing that a terminal obeys.
TEST(SummaryCsv, HoldsNoControlCharacters) {
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[0].label = "\ta\r\n\x1B[31m\"\u202E";
  const std::string text = summary_csv(data);
  EXPECT_NE(text.find("\nplate,\"\\ta\\r\\n\\u001b[31m\"\"\\u202e\",annealing,"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; }), 0);
}

// A problem that lacks another's finding has empty cells.
TEST(SummaryCsv, HasThreeColumnsForEachFinding) {
  ReportData data = fixture::make_data();
  data.problems.push_back(fixture::make_problem());
  data.problems[0].findings = {{.name = "half_life", .title = "half-life"}};
  data.problems[0].table.rows[0].findings["half_life"] = {1.5, 2.5, 3.5};
  std::istringstream lines(summary_csv(data));
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
