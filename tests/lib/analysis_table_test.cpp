// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a comparison.
#include <gtest/gtest.h>

#include <stdexcept>

#include "analysis_trials.h"

namespace nodal {
namespace {

// G* = 1 and G_start = 11: gap 1e-1 is quality 2, gap 1e-2 is 1.1.
struct Race {
  std::vector<TrialRecord> records;
  std::vector<RowRequest> rows = {
      {"base", "base", true}, {"quick", "quick", false}, {"lame", "lame", false}, {"gone", "gone", false}};

  Race() {
    for (int r = 0; r < 5; ++r) records.push_back(trial("base", r, {{20 + 10 * r, 1.9}, {78 + r, r < 3 ? 1.05 : 1.2}}));
    for (int r = 0; r < 4; ++r) records.push_back(trial("quick", r, {{5 + r, 1.5}, {10 + r, 1.0}}, 20));
    for (int r = 0; r < 3; ++r) records.push_back(trial("lame", r, {{50, r == 0 ? 1.8 : 9.0}}));
    TrialRecord other = trial("base", 0, {{1, 0.5}});
    other.problem = "q";
    records.push_back(other);
  }
  ProblemTable table(std::optional<KnownOptimum> known = KnownOptimum{1.0, "by hand", {}}) const {
    return make_table("p", std::move(known), rows, records);
  }
};

TEST(Table, HasARowPerRequestInTheOrderAskedFor) {
  const Race race;
  const ProblemTable table = race.table();
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[0].label, "base");
  EXPECT_TRUE(table.rows[0].baseline);
  EXPECT_EQ(table.rows[0].trials, 5u);
  EXPECT_EQ(table.rows[1].trials, 4u);
  EXPECT_EQ(table.rows[2].trials, 3u);
  EXPECT_EQ(table.reference.label, "p");
  EXPECT_EQ(table.reference.best_quality, 1.0);
  EXPECT_EQ(table.reference.origin, "by hand");
  EXPECT_FALSE(table.reference.provisional);
  EXPECT_EQ(table.start_quality, 11.0);
  EXPECT_EQ(table.start_relative_error, 1.0);
}

TEST(Table, StatesSuccessOfAllRepeats) {
  const Race race;
  const ProblemTable table = race.table();
  EXPECT_DOUBLE_EQ(table.rows[0].target(1e-1).success_rate, 1.0);
  EXPECT_DOUBLE_EQ(table.rows[0].target(1e-2).success_rate, 0.6);
  EXPECT_DOUBLE_EQ(table.rows[1].target(1e-2).success_rate, 1.0);
  EXPECT_DOUBLE_EQ(table.rows[1].target(1e-8).success_rate, 1.0);
  EXPECT_DOUBLE_EQ(table.rows[2].target(1e-1).success_rate, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(table.rows[2].target(1e-2).success_rate, 0.0);
  EXPECT_THROW((void)table.rows[0].target(0.5), std::logic_error);
}

TEST(Table, SaysHowManyCoordinatesLieAtABound) {
  std::vector<TrialRecord> records = {trial("a", 0, {}), trial("a", 1, {}), trial("a", 2, {})};
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  EXPECT_FALSE(make_table("p", std::nullopt, rows, records).rows[0].at_bounds);  // records of an older build
  for (std::int64_t r = 0; r < 3; ++r) records[static_cast<std::size_t>(r)].best->at_bounds = 2 * r;
  expect_quartiles(make_table("p", std::nullopt, rows, records).rows[0].at_bounds, 1.0, 2.0, 3.0);
}

TEST(Table, CountsTrialsThatWereDisturbed) {
  std::vector<TrialRecord> records = {trial("a", 0, {}), trial("a", 1, {}), trial("a", 2, {})};
  for (TrialRecord& record : records) record.seconds.cpu = record.seconds.total;
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  EXPECT_EQ(make_table("p", std::nullopt, rows, records).rows[0].contaminated, 0u);
  records[0].seconds.cpu *= 0.5;
  records[2].conditions = Conditions{"", "", 3, 2, false, false};
  EXPECT_EQ(make_table("p", std::nullopt, rows, records).rows[0].contaminated, 2u);
}

// Two of five ran alone, one of these on a slow core: seconds are those of the other, evaluations of all five. Where
// none ran alone, seconds are those of the undisturbed.
TEST(Table, TakesTimesFromTrialsThatRanAloneAndUndisturbed) {
  std::vector<TrialRecord> records;
  for (int repeat = 0; repeat < 5; ++repeat) {
    TrialRecord& record = records.emplace_back(trial("a", repeat, {{10 * (repeat + 1), 1.0}}));
    record.seconds.cpu = record.seconds.total = 1.0 + repeat;
    record.conditions = Conditions{"", "", repeat < 3 ? 2 : 1, 2, false, false};
  }
  records[4].conditions->pace = 1.3;
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  const KnownOptimum known{0.9, "made"};
  const auto row = [&] { return make_table("p", known, rows, records).rows[0]; };
  EXPECT_EQ(row().timed, 1u);
  EXPECT_TRUE(row().timed_alone);
  expect_quartiles(row().seconds, 4.0, 4.0, 4.0);
  EXPECT_DOUBLE_EQ(row().target(1e-1).median[static_cast<std::size_t>(Axis::seconds)].value(), 4.0);
  EXPECT_DOUBLE_EQ(row().target(1e-1).median[static_cast<std::size_t>(Axis::evaluations)].value(), 30.0);
  EXPECT_EQ(make_curve(pointers(records), Axis::seconds).back().position, 4.0);
  EXPECT_EQ(make_curve(pointers(records), Axis::evaluations).back().quality.median, 1.0);
  records[3].conditions->jobs = 2;
  EXPECT_EQ(row().timed, 4u);
  EXPECT_FALSE(row().timed_alone);
  expect_quartiles(row().seconds, 1.75, 2.5, 3.25);
  for (TrialRecord& record : records) record.conditions->pace = 1.3;
  EXPECT_EQ(row().timed, 5u);
}

// Beside others twelve of fifteen died; the three that are left have run alone.
TEST(Table, TimesKeepTheShareOfTrialsThatFailed) {
  std::vector<TrialRecord> records;
  for (int repeat = 0; repeat < 15; ++repeat) {
    TrialRecord& record = records.emplace_back(trial("a", repeat, {{10, 1.0}}));
    record.seconds.cpu = record.seconds.total;
    record.conditions = Conditions{"", "", repeat % 5 == 0 ? 1 : 2, 2, false, false};
    if (repeat % 5 > 0) record.end = End::crashed;
  }
  for (std::size_t i = 0; i < 15; ++i)
    if (records[i].end == End::crashed) records[i].trace.clear();
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  const OptimizerRow row = make_table("p", KnownOptimum{0.9, "made"}, rows, records).rows[0];
  EXPECT_EQ(timed_trials(pointers(records)).size(), 15u);
  EXPECT_EQ(row.timed, 3u);
  EXPECT_TRUE(row.timed_alone);
  EXPECT_FALSE(row.target(1e-1).median[static_cast<std::size_t>(Axis::seconds)]);
  expect_quartiles(row.seconds, 10.0, 10.0, 10.0);
}

// One job here and one in another comparison are two.
TEST(Table, ATrialBesideAnotherComparisonDidntRunAlone) {
  TrialRecord record = trial("a", 0, {});
  EXPECT_TRUE(ran_alone(record));
  record.conditions = Conditions{"", "", 1, 2, false, false};
  EXPECT_TRUE(ran_alone(record));
  record.conditions->beside_others = true;
  EXPECT_FALSE(ran_alone(record));
}

TEST(Table, CountsATrialThatNeverGotThereAsInfinitelyLong) {
  const Race race;
  const ProblemTable table = race.table();
  const auto evaluations = static_cast<std::size_t>(Axis::evaluations),
             seconds = static_cast<std::size_t>(Axis::seconds);
  EXPECT_EQ(table.rows[0].target(1e-1).median[evaluations], 40.0);
  EXPECT_EQ(table.rows[0].target(1e-2).median[evaluations], 80.0);  // 78, 79, 80, never, never
  EXPECT_FALSE(table.rows[0].target(1e-3).median[evaluations].has_value());
  EXPECT_EQ(table.rows[1].target(1e-1).median[evaluations], 6.5);
  EXPECT_DOUBLE_EQ(*table.rows[1].target(1e-1).median[seconds], 0.65);
  EXPECT_FALSE(table.rows[2].target(1e-1).median[evaluations].has_value());  // 50, never, never
}

TEST(Table, SaysNeverWhenTheMedianLiesBetweenANumberAndNever) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 4; ++r) records.push_back(trial("a", r, {{10 + r, r < 2 ? 1.0 : 9.0}}));
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  const TargetRow target = make_table("p", KnownOptimum{1.0, "", {}}, rows, records).rows[0].target(1e-2);
  EXPECT_FALSE(target.median[1].has_value());
  EXPECT_EQ(target.success_rate, 0.5);
}

TEST(Table, StatesMultiplesOfTheBaseline) {
  const Race race;
  const ProblemTable table = race.table();
  const auto evaluations = static_cast<std::size_t>(Axis::evaluations),
             seconds = static_cast<std::size_t>(Axis::seconds);
  EXPECT_DOUBLE_EQ(*table.rows[1].target(1e-1).multiple[evaluations], 40.0 / 6.5);
  EXPECT_DOUBLE_EQ(*table.rows[1].target(1e-1).multiple[seconds], 40.0 / 6.5);
  EXPECT_DOUBLE_EQ(*table.rows[1].target(1e-2).multiple[evaluations], 80.0 / 11.5);
  EXPECT_EQ(table.rows[0].target(1e-1).multiple[evaluations], 1.0);
  EXPECT_FALSE(table.rows[1].target(1e-3).multiple[evaluations].has_value());  // the baseline never
  EXPECT_FALSE(table.rows[2].target(1e-1).multiple[evaluations].has_value());  // this one never
}

TEST(Table, StatesNoMultiplesWithoutABaseline) {
  Race race;
  race.rows[0].baseline = false;
  for (const OptimizerRow& row : race.table().rows)
    for (const TargetRow& target : row.targets)
      for (const auto& multiple : target.multiple) EXPECT_FALSE(multiple.has_value());
}

TEST(Table, HasAnEmptyRowForAnOptimizerWithoutTrials) {
  const Race race;
  const OptimizerRow row = race.table().rows[3];
  EXPECT_EQ(row.trials, 0u);
  EXPECT_FALSE(row.quality || row.relative_error || row.evaluations || row.seconds || row.work);
  for (const TargetRow& target : row.targets) {
    EXPECT_EQ(target.success_rate, 0.0);
    EXPECT_FALSE(target.median[0] || target.median[1] || target.median[2]);
  }
}

TEST(Table, StatesQuartilesOfTheBestPoints) {
  const Race race;
  const ProblemTable table = race.table();
  expect_quartiles(table.rows[0].quality, 1.05, 1.05, 1.2);
  expect_quartiles(table.rows[0].relative_error, 0.5, 0.5, 0.5);
  expect_quartiles(table.rows[1].evaluations, 20.0, 20.0, 20.0);
  expect_quartiles(table.rows[1].factorizations, 21.0, 21.0, 21.0);
  expect_quartiles(table.rows[1].seconds, 2.0, 2.0, 2.0);
  expect_quartiles(table.rows[1].work, 20.0, 20.0, 20.0);
}

// Flops are counted where a full value has a number of them.
TEST(Table, SaysByWhatTrialsCanBeToldApart) {
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  std::vector<TrialRecord> records = {trial("a", 0, {}), trial("a", 1, {})};
  const auto axes = [&] { return make_table("p", std::nullopt, rows, records).axes; };
  for (TrialRecord& record : records) record.work.factorizations = 1;
  EXPECT_EQ(axes(), (std::vector{Axis::seconds, Axis::evaluations}));
  records[1].work.factorizations = 2;
  EXPECT_EQ(axes(), (std::vector{Axis::seconds, Axis::evaluations, Axis::factorizations}));
  records[0].work.flops = 50;
  records[0].flops_per_value = 100.0;
  EXPECT_EQ(axes(), (std::vector{Axis::seconds, Axis::evaluations, Axis::factorizations, Axis::work}));
}

TEST(Table, CountsFailuresAndNamesEachReasonOnce) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 6; ++r) records.push_back(trial("a", r, {}));
  records[1].end = End::failed;
  records[2].end = End::crashed;
  records[3].end = End::timeout;
  records[4].end = End::failed;
  records[5].end = End::target;
  for (int r : {1, 4}) records[static_cast<std::size_t>(r)].reason = "lost";
  records[2].reason = "died";
  records[3].reason = "hung";
  const std::vector<RowRequest> rows = {{"a", "a", false}};
  const ProblemTable table = make_table("p", std::nullopt, rows, records);
  EXPECT_EQ(table.rows[0].failed, 4u);
  EXPECT_EQ(table.rows[0].reasons, (std::vector<std::string>{"lost", "died", "hung"}));
}

TEST(Table, KeepsATrialWithoutAnyPointAmongTheRepeats) {
  std::vector<TrialRecord> records = {trial("a", 0, {{10, 1.0}}), TrialRecord{}};
  records[1].problem = "p";
  records[1].optimizer = "a";
  records[1].repeat = 1;
  const std::vector<RowRequest> rows = {{"a", "a", true}};
  const ProblemTable table = make_table("p", KnownOptimum{1.0, "", {}}, rows, records);
  EXPECT_EQ(table.rows[0].trials, 2u);
  EXPECT_EQ(table.rows[0].failed, 1u);
  EXPECT_EQ(table.rows[0].target(1e-2).success_rate, 0.5);
  expect_quartiles(table.rows[0].quality, 1.0, 1.0, 1.0);
}

TEST(Table, TakesTheBestOfTheTrialsWhereNothingBetterIsKnown) {
  const Race race;
  const ProblemTable table = race.table(std::nullopt);
  EXPECT_EQ(table.reference.best_quality, 1.0);  // the 0.5 is another problem's
  EXPECT_TRUE(table.reference.provisional);
  EXPECT_EQ(table.reference.origin, "best of these trials");
  EXPECT_EQ(table.rows[1].target(1e-8).success_rate, 1.0);
}

// A trial that starts at 0.73763 and gets no further, and one that does.
ProblemTable table_from(double start, std::optional<double> known, double cost = 0.3) {
  std::vector<TrialRecord> records = {trial("a", 0, {}), trial("b", 0, {{40, start * (1.0 - 1e-12)}})};
  for (TrialRecord& record : records) {
    record.start = {cost, start, 0.02};
    record.trace.front().quality = start;
    record.best->summary.quality = record.trace.back().quality;
  }
  return make_table("p", known ? std::optional(KnownOptimum{*known, "by hand", {}}) : std::nullopt,
                    std::vector<RowRequest>{{"a", "a", true}, {"b", "b", false}}, records);
}

void expect_reached_at_the_start(const ProblemTable& table) {
  for (const OptimizerRow& row : table.rows)
    for (const TargetRow& target : row.targets) {
      EXPECT_EQ(target.success_rate, 1.0) << row.label << ", " << target.gap;
      for (const std::optional<double>& median : target.median)
        EXPECT_EQ(median, 0.0) << row.label << ", " << target.gap;
    }
}

TEST(Table, CountsAStartThatIsTheBestKnownAsThere) {
  expect_reached_at_the_start(table_from(0.73763, 0.73763));
  expect_reached_at_the_start(table_from(0.73763, 0.7376));          // as people write it down
  expect_reached_at_the_start(table_from(2.8e-17, 1.4e-17, 1e-34));  // a perfect fit
}

// The best of trials that found nothing: nobody knows how far away the best is.
TEST(Table, CountsNothingAsReachedWhereNoTrialImprovedOnAProvisionalBest) {
  const ProblemTable table = table_from(0.73763, std::nullopt);
  EXPECT_TRUE(table.reference.unimproved);
  EXPECT_FALSE(table.start_is_best);
  for (const OptimizerRow& row : table.rows)
    for (const TargetRow& target : row.targets) {
      EXPECT_EQ(target.reached, 0u);
      EXPECT_FALSE(target.median[0].has_value());
    }
  EXPECT_FALSE(table_from(0.73763, 0.7).reference.unimproved);            // given: something is known
  expect_reached_at_the_start(table_from(2.8e-17, std::nullopt, 1e-34));  // a perfect fit is the best there is
  // One trial that found something gives it a meaning, also for one that began there.
  std::vector<TrialRecord> records = {trial("a", 0, {{7, 1.0}}), trial("a", 1, {})};
  records[1].start.quality = records[1].trace[0].quality = records[1].best->summary.quality.emplace(1.0);
  const ProblemTable improved = make_table("p", std::nullopt, std::vector<RowRequest>{{"a", "a", true}}, records);
  EXPECT_FALSE(improved.reference.unimproved);
  EXPECT_EQ(improved.rows[0].target(1e-8).success_rate, 1.0);
}

// Whatever was given, all is measured against the best that is known now.
TEST(Table, ScoresAgainstATrialThatBeatsWhatWasGiven) {
  std::vector<TrialRecord> records = {trial("a", 0, {{7, 1.0}}), trial("b", 0, {{3, 1.5}})};
  const std::vector<RowRequest> rows = {{"a", "a", true}, {"b", "b", false}};
  const ProblemTable table = make_table("p", KnownOptimum{2.0, "a paper", {}}, rows, records);
  EXPECT_EQ(table.reference.best_quality, 1.0);
  EXPECT_EQ(table.reference.given.value_or(0.0), 2.0);
  EXPECT_EQ(table.reference.origin, "best of these trials, below the 2 that was given (a paper)");
  EXPECT_TRUE(table.reference.provisional);
  EXPECT_EQ(table.rows[0].target(1e-8).success_rate, 1.0);
  EXPECT_EQ(table.rows[1].target(1e-3).success_rate, 0.0) << "at the old 2.0 it would have been there";
  // The same, as people write it down, is not beaten.
  EXPECT_EQ(table_from(0.73763, 0.7376).reference.given, std::nullopt);
  EXPECT_EQ(table_from(0.73756, 0.7376).reference.given, std::nullopt);
  EXPECT_EQ(table_from(0.73763, std::nullopt).reference.given, std::nullopt);
  // A start that is better than what was given, and that nobody improved, says nothing of how far the best is.
  EXPECT_TRUE(table_from(0.5, 0.73763).reference.unimproved);
}

TEST(Table, KnowsAQualityOnlyToItsDigits) {
  EXPECT_EQ(table_from(0.73766, 0.7376).rows[0].targets[0].success_rate, 0.0);   // rounds to 0.7377
  EXPECT_EQ(table_from(0.73763, 0.73762).rows[0].targets[0].success_rate, 0.0);  // given with five digits
  EXPECT_EQ(table_from(1.3, 1.0).rows[0].targets[0].success_rate, 0.0);          // one digit, but never beyond 1e-4
  EXPECT_EQ(table_from(1e-3, 0.0).rows[0].targets[0].success_rate, 0.0);
}

TEST(Table, OfNoTrialsSaysNothing) {
  const std::vector<RowRequest> rows = {{"a", "a", true}};
  const ProblemTable table = make_table("p", std::nullopt, rows, {});
  EXPECT_TRUE(table.reference.provisional);
  EXPECT_FALSE(table.start_quality.has_value());
  EXPECT_EQ(table.rows[0].trials, 0u);
}

}  // namespace
}  // namespace nodal
