// SPDX-License-Identifier: GPL-3.0-or-later
// How many of the repeats are runs of their own, and starts that are the best there is.
#include <gtest/gtest.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

// Values at a gap of 1e-2 for quality 1.1 and below; G at the start is 11, G* is 1.
TargetRow success_of(const std::vector<TrialRecord>& records, bool deterministic = false, double gap = 1e-2) {
  const std::vector<RowRequest> rows = {{"a", "a", false, deterministic}};
  return make_table("p", KnownOptimum{1.0, "", {}}, rows, records).rows[0].target(gap);
}

void expect_success(const TargetRow& target, std::size_t reached, std::size_t runs) {
  EXPECT_EQ(target.reached, reached);
  EXPECT_EQ(target.runs, runs);
  EXPECT_DOUBLE_EQ(target.success_rate, static_cast<double>(reached) / static_cast<double>(runs));
}

// A multi-start method: its first run is the same every time, what it draws afterwards gains rounding.
TEST(DistinctRuns, CountOnceWhereAllUntilTheGapWasTheSame) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 15; ++r) records.push_back(trial("a", r, {{7, 5.0}, {20, 1.05}, {60 + r, 1.0 - 1e-12 * r}}));
  expect_success(success_of(records), 1, 1);
  expect_success(success_of(records, false, 1e-1), 1, 1);
  expect_success(success_of(records, false, 1e-3), 15, 15);  // there every one got on its own
  records[3].trace[2].quality = 1.06;                        // another way, in the last of them
  expect_success(success_of(records), 15, 15);               // so chance had a part in all of them
}

TrialRecord dead(int repeat) {
  TrialRecord record = trial("a", repeat, {});
  record.end = End::crashed;
  record.start = {};
  record.trace.clear();
  record.best.reset();
  return record;
}

// 13 of 15, not one of three: those that died say nothing of their start, which is that of all.
TEST(DistinctRuns, KeepTheShareOfThoseThatDied) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 15; ++r) records.push_back(r < 2 ? dead(r) : trial("a", r, {{7, 1.05}}));
  for (const bool deterministic : {false, true}) expect_success(success_of(records, deterministic), 13, 15);
  for (TrialRecord& record : records) record = dead(record.repeat);
  for (const bool deterministic : {false, true}) expect_success(success_of(records, deterministic), 0, 15);
}

// Of another optimizer it is known where repeat 1 began.
TEST(DistinctRuns, OfADeadTrialBeginWhereOthersOfItsRepeatDid) {
  std::vector<TrialRecord> records = {trial("a", 0, {{7, 1.0}}), dead(1), trial("b", 0, {}), trial("b", 1, {})};
  records[3].start.quality = 12.0;
  const std::vector<RowRequest> rows = {{"a", "a", false, true}, {"b", "b"}};
  expect_success(make_table("p", KnownOptimum{1.0, "", {}}, rows, records).rows[0].target(1e-2), 1, 2);
}

TEST(DistinctRuns, CountEachAloneWhereARandomMethodNeverGotThere) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 15; ++r) records.push_back(trial("a", r, {}));  // nothing better than the start was drawn
  expect_success(success_of(records), 0, 15);
  records[0] = trial("a", 0, {{7, 1.0}});
  records[1] = trial("a", 1, {{7, 1.0}});
  expect_success(success_of(records), 2, 15);
}

TEST(DistinctRuns, OfADeterministicMethodAreItsStarts) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 3; ++r) records.push_back(trial("a", r, {{7, 5.0}}));
  expect_success(success_of(records, true), 0, 1);
  for (TrialRecord& record : records) record.trace[1].quality = 1.0;
  expect_success(success_of(records, true), 1, 1);
  // The clock ended one of them before it got there: that is said, not averaged away.
  records[2].trace.pop_back();
  expect_success(success_of(records, true), 2, 3);
}

TEST(DistinctRuns, FromOtherStartsAreOthers) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 4; ++r) {
    records.push_back(trial("a", r, {{7, 1.0}}));
    records.back().start.quality = records.back().trace[0].quality = 11.0 + r;
  }
  records.push_back(trial("a", 4, {{7, 1.0}}));  // from the first's start
  for (const bool deterministic : {false, true}) expect_success(success_of(records, deterministic), 4, 4);
  const std::vector<RowRequest> rows = {{"a", "a", false, true}};
  const OptimizerRow row = make_table("p", KnownOptimum{1.0, "", {}}, rows, records).rows[0];
  EXPECT_EQ(row.starts, 4u);
  EXPECT_EQ(row.trials, 5u);
  EXPECT_TRUE(row.deterministic);
}

TEST(StartAtTheBest, IsReachedAtOnceByEveryMethod) {
  // Where nothing is left but rounding: methods end a little above and below, and none finds a way on.
  std::vector<TrialRecord> records = {trial("a", 0, {}), trial("a", 1, {}), trial("b", 0, {}), trial("b", 1, {})};
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].start = {1e-34, 2.776e-17, 1e-17};
    records[i].trace = {{0, 0.001, 1, 2.776e-17}};
    records[i].best = BestPoint{0, {1e-34, i == 0 ? 1.388e-17 : 1.5e-16, 1e-17}, {}};
  }
  const std::vector<RowRequest> rows = {{"a", "a", true}, {"b", "b", false}};
  const ProblemTable table = make_table("p", std::nullopt, rows, records);
  EXPECT_TRUE(table.start_is_best);
  for (const OptimizerRow& row : table.rows)
    for (const TargetRow& target : row.targets) {
      expect_success(target, 1, 1);
      for (const std::optional<double>& median : target.median) EXPECT_EQ(median, 0.0);
      EXPECT_FALSE(target.multiple[0] && row.label == "b");  // nobody is faster
    }
}

TEST(StartAtTheBest, IsToldFromAStartThatIsGood) {
  const ProblemReference measured{"p", 0.73762, "", true, false},
      given{"p", 0.7376, "as a page prints it", false, false};
  EXPECT_TRUE(starts_at_best({{}, 0.73762, {}}, measured));
  EXPECT_TRUE(starts_at_best({{}, 0.7, {}}, measured));
  EXPECT_TRUE(starts_at_best({{}, 0.73762 * (1.0 + 5e-10), {}}, measured));
  EXPECT_FALSE(starts_at_best({{}, 0.73762 * (1.0 + 2e-9), {}}, measured));
  EXPECT_TRUE(starts_at_best({{}, 0.73763, {}}, given));  // rounded to four digits they are the same
  EXPECT_FALSE(starts_at_best({{}, 0.7377, {}}, given));
  const ProblemReference zero{"p", 0.0, "", false, false};
  EXPECT_TRUE(starts_at_best({1e-25, 1e-12, {}}, zero));  // a perfect fit, as far as a race can tell
  EXPECT_FALSE(starts_at_best({{}, 1e-15, {}}, zero));    // in what units?
  EXPECT_FALSE(starts_at_best({1e-18, 1e-9, {}}, zero));
  EXPECT_TRUE(starts_at_best({{}, 0.0, {}}, zero));
  EXPECT_FALSE(starts_at_best({}, zero));
}

}  // namespace
}  // namespace nodal
