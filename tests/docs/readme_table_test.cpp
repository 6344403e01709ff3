// SPDX-License-Identifier: GPL-3.0-or-later
// README's table is what the program prints: its shape, and every figure that doesn't depend on the clock.
// Deterministic methods are run for that; the others would have to run for half a minute.
#include "readme_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include <nodal/trial.h>

#include <report/table.h>

#include "../support/components.h"
#include "config_reference.h"
#include "pages.h"

namespace nodal::docs {
namespace {

const std::string kHowToMend =
    "README.md's table differs from what the program prints; make it again with\n  " NODAL_PROGRAM
    " compare " NODAL_SOURCE_DIR "/bench/scenes/plate.toml && " PAGE_TABLE_TOOL " " NODAL_SOURCE_DIR
    "/README.md results/plate";

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

double count_of(std::string text) {
  std::erase(text, ',');
  double value = -1.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// The default race as far as it is deterministic, and README's table beside it.
class ReadmeTable : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_complete(components())) GTEST_SKIP() << "this build lacks a library";
    std::istringstream page(table_of(read_page("../README.md")));
    for (std::string line; std::getline(page, line);) lines_.push_back(line);
    ASSERT_GT(lines_.size(), 4u) << kHowToMend;
  }

  static bool ended_by_clock(const TrialRecord& record) {
    return record.end == End::budget && record.reason.find("seconds") != std::string::npos;
  }

  report::ProblemReport race() {
    std::vector<RowRequest> rows;
    std::vector<TrialRecord> records;
    for (std::size_t i = 0; i < study_.optimizers.size(); ++i) {
      const StudyOptimizer& o = study_.optimizers[i];
      rows.push_back({o.label, o.use, o.baseline, o.deterministic});
      if (o.deterministic) records.push_back(run_trial(study_, {0, i, 0}, components()));
      if (o.deterministic && ended_by_clock(records.back())) by_clock_.push_back(o.label);
    }
    report::ProblemReport problem;
    problem.quality_name = components().find_problem(study_.problems[0].kind)->quality_name;
    problem.table = make_table(study_.problems[0].label, study_.problems[0].best_known, rows, records);
    return problem;
  }

  // The row of a label, empty when there is none.
  std::vector<std::string> row_of(const StudyOptimizer& optimizer) const {
    const std::string first = optimizer.label + (optimizer.baseline ? " (baseline)" : "");
    for (const std::string& line : lines_)
      if (std::vector<std::string> cells = cells_of(line); !cells.empty() && cells[0] == first) return cells;
    return {};
  }

  std::vector<std::string> lines_, by_clock_;
  const Study study_ = read_study(NODAL_SOURCE_DIR "/bench/scenes/plate.toml", components());
};

TEST_F(ReadmeTable, HasTheColumnsAndRowsOfTheProgram) {
  const report::ProblemReport problem = race();
  const report::Table table = report::make_text_table(problem);
  EXPECT_EQ(lines_[0], problem.table.reference.label + ": " + report::describe_reference(problem)) << kHowToMend;
  std::string titles, subtitles;
  for (const report::Column& column : table.columns) {
    titles += column.title + " ";
    subtitles += column.subtitle + " ";
  }
  EXPECT_EQ(words_of(lines_[2]), words_of(titles)) << kHowToMend;
  EXPECT_EQ(words_of(lines_[3]), words_of(subtitles)) << kHowToMend;
  EXPECT_EQ(lines_.size() - 4, study_.optimizers.size()) << kHowToMend;
  for (const StudyOptimizer& optimizer : study_.optimizers)
    EXPECT_EQ(row_of(optimizer).size(), table.columns.size()) << optimizer.label << "\n" << kHowToMend;
}

// Another compiler or instruction set rounds otherwise, and methods that grope for the last digits of a minimum then
// end earlier or later: ceres-dogleg after 41 evaluations or 165. A factor of eight is room for that.
TEST_F(ReadmeTable, HasTheFiguresOfDeterministicMethods) {
  const report::Table table = report::make_text_table(race());
  std::size_t compared = 0;
  for (const StudyOptimizer& optimizer : study_.optimizers) {
    const std::vector<std::string> theirs = row_of(optimizer);
    const auto at = std::ranges::find(table.optimizers, optimizer.label) - table.optimizers.begin();
    const std::vector<std::string>& ours = table.rows.at(static_cast<std::size_t>(at));
    ASSERT_EQ(theirs.size(), ours.size()) << kHowToMend;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const report::Column& column = table.columns[c];
      const std::string where = optimizer.label + ", " + column.title + " " + column.subtitle + "\n" + kHowToMend;
      if (column.title == "runs") {
        const std::string runs = optimizer.deterministic ? fmt::format("det. {}", std::min(3, study_.repeats))
                                                         : std::to_string(study_.repeats);
        EXPECT_EQ(theirs[c], runs) << where;
      }
      if (!optimizer.deterministic || std::ranges::count(by_clock_, optimizer.label) > 0) continue;
      if (column.title == "relative" || column.title == "G" || column.title == "reached") {
        EXPECT_EQ(theirs[c], ours[c]) << where;
        ++compared;
      }
      if (column.title == "evalu-" || column.title == "factori-") {
        EXPECT_NEAR(std::log2(count_of(theirs[c]) / count_of(ours[c])), 0.0, 3.0) << where;
      }
    }
  }
  EXPECT_GT(compared, 3u);  // the clock may end some on a slow machine, but not all
}

TEST(ReadmeTableText, IsReplacedAndNothingElse) {
  const std::string readme = "# x\n\n```\nelastic: G at the start 1\n\na  b\n```\n\nrest\n```\nother\n```\n";
  EXPECT_EQ(table_of(readme), "elastic: G at the start 1\n\na  b");
  report::ReportData data;
  data.problems.emplace_back().table.reference = {"elastic", 0.5, "known", false};
  EXPECT_EQ(with_table(readme, data).substr(0, 9), "# x\n\n```\n");
  EXPECT_TRUE(with_table(readme, data).ends_with("\n```\n\nrest\n```\nother\n```\n")) << with_table(readme, data);
  EXPECT_THROW((void)table_of("# x\n"), InputError);
  EXPECT_EQ(cells_of("a b (c)     [1, 2]  3,4"), (std::vector<std::string>{"a b (c)", "[1, 2]", "3,4"}));
}

}  // namespace
}  // namespace nodal::docs
