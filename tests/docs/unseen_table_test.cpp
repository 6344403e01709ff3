// SPDX-License-Identifier: GPL-3.0-or-later
// The table of docs/unseen_loads.md is of the study as it is, and its finding is still found.
#include "unseen_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/file.h>
#include <nodal/trial.h>

#include "../support/components.h"
#include "config_reference.h"
#include "marked_table.h"
#include "pages.h"

namespace nodal::docs {
namespace {

const std::string kHowToMend = "docs/unseen_loads.md's table is of another study; make it again with\n  " NODAL_PROGRAM
                               " compare " NODAL_SOURCE_DIR "/bench/scenes/unseen.toml && " PAGE_TABLE_TOOL
                               " " NODAL_SOURCE_DIR "/docs/unseen_loads.md results/unseen";

class UnseenTable : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_complete(components())) GTEST_SKIP() << "this build lacks a library";
    rows_ = marked_rows(read_page("unseen_loads.md"), kUnseenStudy);
    study_ = read_study(NODAL_SOURCE_DIR "/bench/scenes/unseen.toml", components());
    study_.budget.seconds.reset();  // figures that don't depend on the machine's speed
    study_.budget.evaluations = 1200;
  }

  std::size_t problem(const std::string& label) const {
    return static_cast<std::size_t>(std::ranges::find(study_.problems, label, &StudyProblem::label) -
                                    study_.problems.begin());
  }
  std::size_t optimizer(const std::string& label) const {
    return static_cast<std::size_t>(std::ranges::find(study_.optimizers, label, &StudyOptimizer::label) -
                                    study_.optimizers.begin());
  }
  TrialRecord run(const std::string& problem_label, const std::string& optimizer_label) const {
    return run_trial(study_, {problem(problem_label), optimizer(optimizer_label), 0}, components());
  }
  // Cook's membrane with its bendings held out, too: they choose the point, the pull reports.
  void choose_by_bendings() {
    const std::string path = NODAL_SOURCE_DIR "/bench/scenes/unseen.toml", held = "held_out = [\"pull\"]";
    std::string text = read_file(path, "study");
    const std::size_t at = text.find(held);
    ASSERT_NE(at, std::string::npos);
    study_ =
        parse_study(text.replace(at, held.size(), "held_out = [\"bend-x\", \"pull\", \"bend-y\"]"), path, components());
    study_.budget = {};
    study_.budget.evaluations = 400;
    study_.budget.validated = true;
  }

  std::vector<std::vector<std::string>> rows_;
  Study study_;
};

double unseen_of(const TrialRecord& record) {
  const auto found = std::ranges::find(record.health.findings, std::string(kUnseenFinding), &Finding::name);
  return found == record.health.findings.end() ? std::nan("") : found->value;
}

TEST_F(UnseenTable, HasTheScenesAndTheFieldOfTheStudy) {
  ASSERT_EQ(rows_.size(), study_.problems.size() + 2) << kHowToMend;
  std::vector<std::string> head = {"scene", "start"};
  for (const StudyOptimizer& one : study_.optimizers) head.push_back(one.label);
  EXPECT_EQ(rows_[0], head) << kHowToMend;
  for (std::size_t p = 0; p < study_.problems.size(); ++p) {
    EXPECT_EQ(rows_[p + 2][0], study_.problems[p].label) << kHowToMend;
    EXPECT_EQ(rows_[p + 2].size(), head.size()) << kHowToMend;
  }
}

// Cook's membrane, its shear fitted: what fits best is the worst on the pull, and a prior mends it.
TEST_F(UnseenTable, FindsWhatItSays) {
  const TrialRecord bare = run("cook: shear", "gauss-newton"), with_prior = run("cook: shear, prior", "gauss-newton");
  ASSERT_TRUE(bare.best && with_prior.best);
  EXPECT_LT(*bare.best->summary.relative_error, 0.006);
  EXPECT_GT(unseen_of(bare), 0.25);
  EXPECT_LT(unseen_of(with_prior), 0.08);
  EXPECT_LT(*with_prior.best->summary.relative_error, 2.0 * *bare.best->summary.relative_error);
  EXPECT_NE(unseen_warning(bare).find("above the start's"), std::string::npos) << unseen_warning(bare);
}

// The paper's annealing hardly leaves its start where no load pulls it.
TEST_F(UnseenTable, HasAnAnnealingThatHoldsUnderThePull) {
  study_.budget.evaluations = 100'000;
  const TrialRecord annealed = run("cook: shear", "annealing");
  ASSERT_TRUE(annealed.best);
  EXPECT_LT(*annealed.best->summary.relative_error, 0.02);
  EXPECT_LT(unseen_of(annealed), 0.09);
}

TEST_F(UnseenTable, HasAValidatedStopThatEndsNearThePull) {
  choose_by_bendings();
  const TrialRecord record = run("cook: shear", "gauss-newton");
  ASSERT_TRUE(record.best && record.unseen && record.unseen->stop);
  EXPECT_LT(record.unseen->stop->evaluation, record.unseen->stop->fitted_evaluation);
  EXPECT_LT(*record.best->summary.relative_error, 0.03);
  EXPECT_LT(unseen_of(record), 0.09);
  const UnseenPoint* end = record.unseen->at(record.unseen->stop->fitted_evaluation);
  ASSERT_TRUE(end);
  EXPECT_GT(record.unseen->error(*end), 1.5 * unseen_of(record));
}

TEST(UnseenTableText, IsReplacedAndNothingElse) {
  const std::string page =
      "# x\n<!-- made from bench/scenes/unseen.toml -->\nold\n<!-- end of what is made -->\nrest\n";
  report::ReportData data;
  report::ProblemReport& problem = data.problems.emplace_back();
  problem.table.reference.label = "plate";
  problem.table.start_relative_error = 0.123;
  problem.table.unseen = UnseenSummary{{"bend-x"}, {}, 0.456};
  OptimizerRow& row = problem.table.rows.emplace_back();
  row.label = "a";
  row.relative_error = Quartiles{0.0, 0.00678, 0.0};
  row.findings[kUnseenFinding] = {0.0, 1.234, 0.0};
  const std::string made = with_marked_table(page, kUnseenStudy, unseen_table(data));
  EXPECT_EQ(made,
            "# x\n<!-- made from bench/scenes/unseen.toml -->\n| scene | start | a |\n|---|---|---|\n| plate | 0.12 / "
            "0.46 | 0.0068 / 1.2 |\n<!-- end of what is made -->\nrest\n");
  EXPECT_EQ(marked_rows(made, kUnseenStudy)[2], (std::vector<std::string>{"plate", "0.12 / 0.46", "0.0068 / 1.2"}));
  EXPECT_EQ(unseen_cell(std::nullopt, 0.5), "– / 0.50");
  EXPECT_THROW((void)marked_rows("# x\n", kUnseenStudy), InputError);
}

}  // namespace
}  // namespace nodal::docs
