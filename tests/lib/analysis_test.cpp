// SPDX-License-Identifier: GPL-3.0-or-later
// Quartiles, times to a quality, and work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <nodal/random.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

}  // namespace
}  // namespace nodal
