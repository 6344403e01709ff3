// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over seconds, evaluations, work and factorizations.
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/random.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

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

TEST(Curve, CountsFactorizationsFromTheStarts) {
  std::vector<TrialRecord> records = {trial("a", 0, {{9, 5.0}})};  // its point comes with factorization 10 of 101
  const std::vector<CurvePoint> curve = make_curve(pointers(records), Axis::factorizations, 3);
  ASSERT_EQ(curve.size(), 3u);
  EXPECT_EQ(curve.front().position, 1.0);
  EXPECT_EQ(curve.back().position, 101.0);
  EXPECT_EQ(curve[0].quality.median, 11.0);
  EXPECT_EQ(curve[1].quality.median, 5.0);  // at 10.05
  records[0].work.factorizations = 0;       // nothing was factorized: there is no axis
  EXPECT_TRUE(make_curve(pointers(records), Axis::factorizations, 3).empty());
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
  EXPECT_EQ(to_string(Axis::factorizations), "factorizations");
}

TEST(UnseenCurve, IsOfWhatReportsAndMayRise) {
  std::vector<TrialRecord> trials = {trial("a", 0, {{10, 5.0}, {50, 1.0}})};
  EXPECT_TRUE(make_unseen_curve(pointers(trials), Axis::evaluations).empty());
  trials[0].unseen = UnseenRecord{
      {"x", "y"},
      {{{0, 0.001, 1, 11.0}, {0.6, 0.8}}, {{10, 1.0, 11, 5.0}, {0.3, 0.4}}, {{50, 5.0, 51, 1.0}, {3.0, 4.0}}},
      0,
      {}};
  const std::vector<CurvePoint> curve = make_unseen_curve(pointers(trials), Axis::evaluations, 3);
  ASSERT_EQ(curve.size(), 3u);
  EXPECT_DOUBLE_EQ(curve[0].quality.median, std::sqrt(0.5));
  EXPECT_EQ(curve[1].position, 10.0);
  EXPECT_DOUBLE_EQ(curve[1].quality.median, std::sqrt(0.125));
  EXPECT_EQ(curve[2].position, 100.0);
  EXPECT_DOUBLE_EQ(curve[2].quality.median, std::sqrt(12.5));
  trials[0].unseen->stop = ValidatedStop{10, 50, 1.0};
  EXPECT_DOUBLE_EQ(make_unseen_curve(pointers(trials), Axis::evaluations, 3)[1].quality.median, 0.4);
  // A trial without any doesn't dilute the others.
  trials.push_back(trial("a", 1, {{10, 5.0}}));
  EXPECT_EQ(make_unseen_curve(pointers(trials), Axis::seconds, 3).size(), 3u);
}

TEST(UnseenSummary, SaysWhoChoosesAndWhoReports) {
  std::vector<TrialRecord> trials = {trial("a", 0, {{10, 5.0}})};
  const std::vector<RowRequest> rows = {{"a", "a", false, false}};
  EXPECT_FALSE(make_table("p", std::nullopt, rows, trials).unseen);
  trials[0].unseen = UnseenRecord{{"x", "y", "z"}, {{{0, 0.001, 1, 11.0}, {0.6, 0.8, 0.0}}}, 0, {}};
  UnseenSummary summary = *make_table("p", std::nullopt, rows, trials).unseen;
  EXPECT_EQ(summary.reported, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_TRUE(summary.chosen_by.empty());
  EXPECT_DOUBLE_EQ(*summary.start, std::sqrt(1.0 / 3.0));
  trials[0].unseen->stop = ValidatedStop{};
  summary = *make_table("p", std::nullopt, rows, trials).unseen;
  EXPECT_EQ(summary.reported, std::vector<std::string>{"y"});
  EXPECT_EQ(summary.chosen_by, (std::vector<std::string>{"x", "z"}));
  EXPECT_DOUBLE_EQ(*summary.start, 0.8);
}

TEST(UnseenRow, IsAgainstEachTrialsOwnStart) {
  std::vector<TrialRecord> trials;
  const double starts[] = {1.0, 4.0, 10.0}, ends[] = {0.5, 3.0, 4.0};
  for (int repeat = 0; repeat < 3; ++repeat) {
    trials.push_back(trial("a", repeat, {{10, 5.0}, {50, 1.0}}));
    trials.back().unseen = UnseenRecord{
        {"x"},
        {{{0, 0.001, 1, 11.0}, {starts[repeat]}}, {{10, 1.0, 11, 5.0}, {0.25}}, {{50, 5.0, 51, 1.0}, {ends[repeat]}}},
        0,
        {}};
  }
  const std::vector<RowRequest> rows = {{"a", "a", false, false}};
  OptimizerRow row = make_table("p", std::nullopt, rows, trials).rows[0];
  ASSERT_TRUE(row.unseen);
  EXPECT_DOUBLE_EQ(row.unseen->error, 3.0);
  EXPECT_DOUBLE_EQ(row.unseen->over_start, 0.5);  // though 3 is more than the first trial's start
  EXPECT_DOUBLE_EQ(row.unseen->least, 0.25);
  EXPECT_EQ(row.unseen_missing, 0u);
  trials[1].unseen->points.pop_back();
  row = make_table("p", std::nullopt, rows, trials).rows[0];
  EXPECT_EQ(row.unseen_missing, 1u);
  EXPECT_DOUBLE_EQ(row.unseen->error, 2.25);
}

}  // namespace
}  // namespace nodal
