// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/analysis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <nodal/random.h>

namespace nodal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A trial from quality 11 that improves at the given evaluations; a second lasts ten of them, no flops are counted.
TrialRecord trial(const std::string& optimizer, int repeat, std::vector<std::pair<std::int64_t, double>> improvements,
                  std::int64_t evaluations = 100) {
  TrialRecord record;
  record.problem = "p";
  record.optimizer = record.use = optimizer;
  record.repeat = repeat;
  record.end = End::budget;
  record.start = {11.0, 11.0, 1.0};
  record.trace.push_back({0, 0.001, 1, 11.0});
  for (const auto& [evaluation, quality] : improvements)
    record.trace.push_back({evaluation, 0.1 * static_cast<double>(evaluation), evaluation + 1, quality});
  record.best = BestPoint{record.trace.back().evaluation, {1.0, record.trace.back().quality, 0.5}, {}};
  record.counts.evaluations = evaluations;
  record.work.factorizations = evaluations + 1;
  record.seconds.total = 0.1 * static_cast<double>(evaluations);
  return record;
}

std::vector<const TrialRecord*> pointers(const std::vector<TrialRecord>& records) {
  std::vector<const TrialRecord*> all;
  for (const TrialRecord& record : records) all.push_back(&record);
  return all;
}

void expect_quartiles(const std::optional<Quartiles>& q, double lower, double median, double upper) {
  ASSERT_TRUE(q.has_value());
  EXPECT_DOUBLE_EQ(q->lower, lower);
  EXPECT_DOUBLE_EQ(q->median, median);
  EXPECT_DOUBLE_EQ(q->upper, upper);
}

TEST(QuartilesOfValues, AreThoseOfHyndmanAndFanType7) {
  EXPECT_FALSE(quartiles({}).has_value());
  expect_quartiles(quartiles({3.0}), 3.0, 3.0, 3.0);
  expect_quartiles(quartiles({2.0, 1.0}), 1.25, 1.5, 1.75);
  expect_quartiles(quartiles({4.0, 1.0, 3.0, 2.0}), 1.75, 2.5, 3.25);             // places 0.75, 1.5, 2.25
  expect_quartiles(quartiles({5.0, 1.0, 3.0, 2.0, 4.0}), 2.0, 3.0, 4.0);          // places 1, 2, 3
  expect_quartiles(quartiles({1.0, 2.0, 4.0, 8.0, 16.0, 32.0}), 2.5, 6.0, 14.0);  // places 1.25, 2.5, 3.75
}

TEST(QuartilesOfValues, MayBeInfinite) {
  expect_quartiles(quartiles({1.0, 2.0, kInfinity}), 1.5, 2.0, kInfinity);
  expect_quartiles(quartiles({1.0, kInfinity, kInfinity}), kInfinity, kInfinity, kInfinity);
  expect_quartiles(quartiles({1.0, 2.0, kInfinity, kInfinity}), 1.75, kInfinity, kInfinity);
  expect_quartiles(quartiles({1.0, 2.0, 3.0, 4.0, kInfinity}), 2.0, 3.0, 4.0);
  expect_quartiles(quartiles({kInfinity}), kInfinity, kInfinity, kInfinity);
}

TEST(QuartilesOfValues, StandInOrderAndGrowWithTheValues) {
  RandomStream random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> values(1 + random.index(9));
    for (double& v : values) v = random.uniform(-5.0, 5.0);
    const Quartiles q = *quartiles(values);
    EXPECT_LE(std::ranges::min(values), q.lower);
    EXPECT_LE(q.lower, q.median);
    EXPECT_LE(q.median, q.upper);
    EXPECT_LE(q.upper, std::ranges::max(values));
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(random.index(values.size())),
                values.end());
    EXPECT_EQ(quartiles(values)->median, q.median);
  }
}

TEST(FirstReached, IsTheFirstPointAtOrBelowTheQuality) {
  const TrialRecord t = trial("a", 0, {{3, 8.0}, {7, 5.0}, {20, 1.5}});
  EXPECT_EQ(first_reached(t, 12.0, Axis::evaluations), 0.0);
  EXPECT_EQ(first_reached(t, 11.0, Axis::evaluations), 0.0);
  EXPECT_EQ(first_reached(t, 10.9, Axis::evaluations), 3.0);
  EXPECT_EQ(first_reached(t, 8.0, Axis::evaluations), 3.0);
  EXPECT_EQ(first_reached(t, 5.0, Axis::seconds), 0.1 * 7.0);
  EXPECT_EQ(first_reached(t, 1.5, Axis::evaluations), 20.0);
  EXPECT_FALSE(first_reached(t, 1.4, Axis::evaluations).has_value());
  EXPECT_FALSE(first_reached(TrialRecord{}, 1.0, Axis::evaluations).has_value());
}

TEST(FirstReached, AgreesWithALookAtEveryPoint) {
  RandomStream random(2);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::pair<std::int64_t, double>> improvements;
    double quality = 11.0;
    for (std::int64_t evaluation = 1; evaluation < 30; ++evaluation)
      if (random.index(3) == 0) improvements.emplace_back(evaluation, quality *= random.uniform(0.5, 1.0));
    const TrialRecord t = trial("a", 0, improvements);
    const double wanted = random.uniform(0.0, 12.0);
    const auto found = std::ranges::find_if(t.trace, [&](const TracePoint& p) { return p.quality <= wanted; });
    const std::optional<double> reached = first_reached(t, wanted, Axis::evaluations);
    ASSERT_EQ(reached.has_value(), found != t.trace.end());
    if (reached) {
      EXPECT_EQ(*reached, static_cast<double>(found->evaluation));
    }
  }
}

// A full value takes 100 flops, 80 of them for its factorization. 9 evaluations after the start's, 5 factorizations at
// 80 in all; the other 300 flops are spread over 10 evaluations.
TEST(Work, CountsFactorizationsAtTheirOwnFlopsAndSpreadsTheRest) {
  TrialRecord t = trial("a", 0, {{4, 5.0}}, 9);
  t.flops_per_value = 100.0;
  t.work = {5, 30, 12, 700.0, 400.0};
  EXPECT_DOUBLE_EQ(position(t, {0, 0.0, 1, 11.0}, Axis::work), (400.0 * 1 / 5 + 300.0 * 1 / 10) / 100.0);
  EXPECT_DOUBLE_EQ(position(t, {4, 0.4, 2, 5.0}, Axis::work), (400.0 * 2 / 5 + 300.0 * 5 / 10) / 100.0);
  EXPECT_DOUBLE_EQ(end_position(t, Axis::work), 7.0);
  EXPECT_DOUBLE_EQ(*first_reached(t, 11.0, Axis::work), 1.1);
}

TEST(Work, OfAMethodThatEvaluatesFullValuesOnlyIsTheNumberOfValues) {
  TrialRecord t = trial("a", 0, {{4, 5.0}}, 9);
  t.flops_per_value = 100.0;
  t.work = {10, 10, 0, 1000.0, 800.0};
  for (std::int64_t i = 0; i <= 9; ++i)
    EXPECT_DOUBLE_EQ(position(t, {i, 0.0, i + 1, 0.0}, Axis::work), static_cast<double>(i + 1));
  EXPECT_DOUBLE_EQ(end_position(t, Axis::work), 10.0);
}

TEST(Work, OfAProblemWithoutFactorizationsIsSpreadEvenly) {
  TrialRecord t = trial("a", 0, {}, 9);
  t.flops_per_value = 10.0;
  t.work = {0, 0, 0, 100.0, 0.0};
  EXPECT_DOUBLE_EQ(position(t, {4, 0.0, 0, 0.0}, Axis::work), 5.0);
}

TEST(Work, OfAProblemThatCountsNoFlopsIsItsEvaluations) {
  const TrialRecord t = trial("a", 0, {{4, 5.0}}, 9);
  EXPECT_EQ(position(t, t.trace[1], Axis::work), 4.0);
  EXPECT_EQ(end_position(t, Axis::work), 9.0);
  EXPECT_EQ(end_position(t, Axis::evaluations), 9.0);
  EXPECT_DOUBLE_EQ(end_position(t, Axis::seconds), 0.9);
}

TEST(Work, OfAbsurdCountsIsANumber) {
  TrialRecord t = trial("a", 0, {{4, 5.0}}, 9);
  t.counts.evaluations = std::numeric_limits<std::int64_t>::max();
  t.flops_per_value = 1.0;
  t.work = {-5, 10, 0, 1e308, -1e308};
  EXPECT_FALSE(std::isnan(end_position(t, Axis::work)));
  t.counts.evaluations = std::numeric_limits<std::int64_t>::min();
  EXPECT_FALSE(std::isnan(position(t, {t.counts.evaluations, 0.0, -1, 0.0}, Axis::work)));
}

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
  expect_success(success_of(records), 2, 2);
  records[4].trace[2].evaluation = 21;
  expect_success(success_of(records), 3, 3);
}

TEST(DistinctRuns, CountEachAloneWhereARandomMethodNeverGotThere) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 15; ++r) records.push_back(trial("a", r, {}));  // nothing better than the start was drawn
  expect_success(success_of(records), 0, 15);
  records[0] = trial("a", 0, {{7, 1.0}});
  records[1] = trial("a", 1, {{7, 1.0}});
  expect_success(success_of(records), 1, 14);
}

TEST(DistinctRuns, OfADeterministicMethodAreItsStarts) {
  std::vector<TrialRecord> records;
  for (int r = 0; r < 3; ++r) records.push_back(trial("a", r, {{7, 5.0}}));
  expect_success(success_of(records, true), 0, 1);
  for (TrialRecord& record : records) record.trace[1].quality = 1.0;
  expect_success(success_of(records, true), 1, 1);
  // The clock ended one of them before it got there: that is said, not averaged away.
  records[2].trace.pop_back();
  expect_success(success_of(records, true), 1, 2);
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
  const ProblemReference measured{"p", 0.73762, "", true, false}, given{"p", 0.7376, "as a page prints it", false, false};
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
      for (const std::optional<double>& median : target.median) EXPECT_EQ(median, 0.0) << row.label << ", " << target.gap;
    }
}

TEST(Table, CountsAStartThatIsTheBestKnownAsThere) {
  expect_reached_at_the_start(table_from(0.73763, 0.73763));
  expect_reached_at_the_start(table_from(0.73763, 0.7376));        // as people write it down
  expect_reached_at_the_start(table_from(0.5, 0.73763));           // better than was known
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
  EXPECT_FALSE(table_from(0.73763, 0.7).reference.unimproved);  // given: something is known
  expect_reached_at_the_start(table_from(2.8e-17, std::nullopt, 1e-34));  // a perfect fit is the best there is
  // One trial that found something gives it a meaning, also for one that began there.
  std::vector<TrialRecord> records = {trial("a", 0, {{7, 1.0}}), trial("a", 1, {})};
  records[1].start.quality = records[1].trace[0].quality = records[1].best->summary.quality.emplace(1.0);
  const ProblemTable improved = make_table("p", std::nullopt, std::vector<RowRequest>{{"a", "a", true}}, records);
  EXPECT_FALSE(improved.reference.unimproved);
  EXPECT_EQ(improved.rows[0].target(1e-8).success_rate, 1.0);
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

TEST(Curve, IsSpacedEvenlyInTheLogarithmFromOneToTheEnd) {
  const std::vector<TrialRecord> records = {trial("a", 0, {{10, 5.0}}), trial("a", 1, {{20, 4.0}})};
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::evaluations, 21);
  ASSERT_EQ(curve.size(), 21u);
  EXPECT_EQ(curve.front().position, 1.0);
  EXPECT_EQ(curve.back().position, 100.0);
  for (std::size_t i = 1; i < curve.size(); ++i)  // 20 steps from 1 to 100; pow is good to a few ulps
    EXPECT_NEAR(curve[i].position / curve[i - 1].position, std::pow(100.0, 1.0 / 20.0), 1e-12);
}

TEST(Curve, HoldsTheQuartilesOfTheBestSoFar) {
  const std::vector<TrialRecord> records = {trial("a", 0, {{10, 5.0}}), trial("a", 1, {{10, 3.0}}),
                                            trial("a", 2, {{50, 1.0}})};
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::evaluations, 3);  // at 1, 10 and 100
  ASSERT_EQ(curve.size(), 3u);
  expect_quartiles(curve[0].quality, 11.0, 11.0, 11.0);
  expect_quartiles(curve[2].quality, 2.0, 3.0, 4.0);
}

TEST(Curve, KeepsTheBestOfATrialThatHasEnded) {
  const std::vector<TrialRecord> records = {trial("a", 0, {{2, 1.0}}, 4), trial("a", 1, {{80, 9.0}}, 100)};
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::evaluations, 50);
  EXPECT_EQ(curve.back().position, 100.0);
  EXPECT_DOUBLE_EQ(curve.back().quality.median, 5.0);
}

// On the axis of seconds trials begin at different moments: 0.001 s, 1 s and 2 s here.
TEST(Curve, BeginsWhereTheMedianTrialHasItsFirstPoint) {
  std::vector<TrialRecord> records = {trial("a", 0, {{50, 5.0}}), trial("a", 1, {{50, 4.0}}),
                                      trial("a", 2, {{50, 3.0}})};
  records[1].trace[0].seconds = 1.0;
  records[2].trace[0].seconds = 2.0;
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::seconds, 30);
  EXPECT_EQ(curve.front().position, 1.0);
  EXPECT_DOUBLE_EQ(curve.back().position, 10.0);
}

// Work at the start may be more than one value's: then the first positions have no trial on the way.
TEST(Curve, LeavesOutPositionsThatFewerThanHalfOfTheTrialsHaveReached) {
  std::vector<TrialRecord> records = {trial("a", 0, {{50, 5.0}}), trial("a", 1, {{50, 4.0}}),
                                      trial("a", 2, {{50, 3.0}})};
  for (TrialRecord& record : records) {
    record.flops_per_value = 1.0;
    record.work = {101, 0, 0, 404.0, 404.0};  // 4 values' worth at every factorization
  }
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::work, 200);
  ASSERT_FALSE(curve.empty());
  EXPECT_GE(curve.front().position, 4.0);
  EXPECT_LT(curve.front().position, 4.2);  // 200 steps over ln 404: 3 % each
  records[0].work = records[1].work = {101, 0, 0, 101.0, 101.0};
  EXPECT_EQ(make_curve(pointers(records), Axis::work, 200).front().position, 1.0);
}

TEST(Curve, FallsMonotonically) {
  RandomStream random(3);
  for (int i = 0; i < 100; ++i) {
    std::vector<TrialRecord> records;
    for (std::size_t n = 1 + random.index(7); n > 0; --n) {
      std::vector<std::pair<std::int64_t, double>> improvements;
      double quality = 11.0;
      for (std::int64_t evaluation = 1; evaluation < 100; ++evaluation)
        if (random.index(5) == 0) improvements.emplace_back(evaluation, quality *= random.uniform(0.5, 1.0));
      records.push_back(trial("a", static_cast<int>(n), improvements));
    }
    for (const Axis axis : {Axis::evaluations, Axis::work}) {
      const std::vector<CurvePoint> curve = make_curve(pointers(records), axis);
      ASSERT_EQ(curve.size(), 120u);
      for (std::size_t j = 1; j < curve.size(); ++j) {
        EXPECT_LT(curve[j - 1].position, curve[j].position);
        EXPECT_GE(curve[j - 1].quality.lower, curve[j].quality.lower);
        EXPECT_GE(curve[j - 1].quality.median, curve[j].quality.median);
        EXPECT_GE(curve[j - 1].quality.upper, curve[j].quality.upper);
      }
    }
  }
}

TEST(Curve, IsEmptyWhereNothingHappened) {
  EXPECT_TRUE(make_curve({}, Axis::evaluations).empty());
  EXPECT_TRUE(make_curve({}, Axis::seconds).empty());
  const std::vector<TrialRecord> lost = {TrialRecord{}, TrialRecord{}};
  for (const Axis axis : {Axis::seconds, Axis::evaluations, Axis::work})
    EXPECT_TRUE(make_curve(pointers(lost), axis).empty());
  const std::vector<TrialRecord> records = {trial("a", 0, {{10, 5.0}})};
  EXPECT_TRUE(make_curve(pointers(records), Axis::evaluations, 1).empty());
}

TEST(Axes, HaveNames) {
  EXPECT_EQ(to_string(Axis::seconds), "seconds");
  EXPECT_EQ(to_string(Axis::evaluations), "evaluations");
  EXPECT_EQ(to_string(Axis::work), "work");
}

}  // namespace
}  // namespace nodal
