// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/kept_points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <nodal/meter.h>

#include "toy.h"

namespace nodal {
namespace {

// A race whose best improves at every evaluation, as the meter tells of it.
KeptPoints race(std::int64_t evaluations, std::size_t coordinates = 1) {
  KeptPoints kept;
  kept.begin(coordinates);
  std::vector<double> x(coordinates);
  for (std::int64_t e = 0; e <= evaluations; ++e) {
    const bool next = kept.due(e);
    if (next && e > 0) kept.keep({e - 1, 0.0, 0, 0.0}, -static_cast<double>(e - 1), x);
    x[0] = static_cast<double>(e);
    if (next) kept.moved_to(e);
  }
  return kept;
}

TEST(KeptPoints, KeepNothingUnasked) {
  KeptPoints kept;
  EXPECT_FALSE(kept.due(0));
  kept.moved_to(17);
  EXPECT_FALSE(kept.due(1'000'000));
  EXPECT_TRUE(kept.points().empty());
}

TEST(KeptPoints, AreEvenlySpacedInTheLogarithm) {
  for (const std::int64_t evaluations : {10, 63, 64, 100, 1000, 123456, 2'000'000}) {
    const std::vector<KeptPoint> points = race(evaluations).points();
    EXPECT_LE(points.size(), KeptPoints::kMost);
    EXPECT_GE(points.size(), std::min<std::size_t>(static_cast<std::size_t>(evaluations), 24)) << evaluations;
    EXPECT_EQ(points.front().at.evaluation, 0);
    double widest = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto before = static_cast<double>(points[i - 1].at.evaluation),
                 here = static_cast<double>(points[i].at.evaluation);
      EXPECT_LT(before, here);
      // Neighbours among whole numbers can't be nearer than one.
      if (here - before > 1.0) widest = std::max(widest, std::log2(here + 1.0) - std::log2(before + 1.0));
      EXPECT_EQ(points[i].x[0], here);
      EXPECT_EQ(points[i].cost, -here);
    }
    // At least half of the intervals that fit are used, and a point lies somewhere in each.
    EXPECT_LE(widest, 4.0 * std::log2(static_cast<double>(evaluations) + 1.0) / KeptPoints::kMost) << evaluations;
  }
}

TEST(KeptPoints, AreFewerOfLargeProblems) {
  const std::size_t coordinates = KeptPoints::kMostBytes / sizeof(double) / 10;
  EXPECT_LE(race(3000, coordinates).points().size(), 10u);
  KeptPoints none;
  none.begin(std::size_t{1} << 60);
  EXPECT_TRUE(none.due(0));
}

TEST(KeptPoints, ForgetWhatIsTakenBack) {
  KeptPoints kept = race(1000);
  kept.forget_after(500);
  EXPECT_LE(kept.points().back().at.evaluation, 500);
  kept.moved_to(500);
  EXPECT_FALSE(kept.due(500));
  EXPECT_TRUE(kept.due(1000));
  kept.forget_after(-1);
  EXPECT_TRUE(kept.points().empty());
  kept.moved_to(-1);
  EXPECT_TRUE(kept.due(1));
}

// A best that was taken back leaves the one before it to be kept once more.
TEST(KeptPoints, HaveNoEvaluationTwice) {
  KeptPoints kept;
  kept.begin(1);
  const std::vector<double> x = {1.0};
  kept.keep({0, 0.0, 0, 9.0}, 9.0, x);
  kept.forget_after(0);
  kept.moved_to(0);
  kept.keep({0, 0.0, 0, 9.0}, 9.0, x);
  ASSERT_EQ(kept.points().size(), 1u);
  kept.keep({10, 0.0, 0, 8.0}, 8.0, x);
  kept.keep({10, 0.0, 0, 8.0}, 8.0, x);
  EXPECT_EQ(kept.points().size(), 2u);
}

TEST(KeptPoints, AreChosenWithFirstAndLast) {
  std::vector<std::int64_t> evaluations;
  for (std::int64_t e = 0; e < 1000; ++e) evaluations.push_back(e);
  for (const std::size_t most : {4, 7, 64}) {
    const std::vector<std::size_t> chosen = evenly_spaced(evaluations, most);
    EXPECT_LE(chosen.size(), most);
    EXPECT_GE(chosen.size(), most / 2);
    EXPECT_EQ(chosen.front(), 0u);
    EXPECT_EQ(chosen.back(), 999u);
  }
  EXPECT_EQ(evenly_spaced(evaluations, 2000).size(), 1000u);
  EXPECT_EQ(evenly_spaced(std::vector<std::int64_t>{0}, 4), std::vector<std::size_t>{0});
  EXPECT_TRUE(evenly_spaced({}, 4).empty());
}

TEST(KeptPoints, OfAMeterAreItsBestPointsBeforeTheLast) {
  const toy::ToyProblem problem(3, toy::bowl, {{"other", toy::bowl}});
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), {});
  std::vector<double> x = {-1.5, -1.5, -1.5};
  for (int i = 0; i < 500; ++i) {
    if (i % 3 == 0) x[0] += 0.01;
    (void)meter.value(x);
  }
  const std::vector<KeptPoint>& kept = meter.kept();
  ASSERT_GT(kept.size(), 16u);
  for (const KeptPoint& point : kept) {
    EXPECT_EQ(point.cost, toy::bowl(point.x));
    EXPECT_EQ(point.at.quality, problem.quality(point.cost));
    EXPECT_TRUE(std::ranges::any_of(meter.trace(), [&](const TracePoint& p) {
      return p.evaluation == point.at.evaluation && p.quality == point.at.quality;
    }));
    EXPECT_LT(point.at.evaluation, meter.best_evaluation());
  }
  EXPECT_EQ(meter.best().cost, meter.best_cost());
  EXPECT_EQ(meter.best().at.evaluation, meter.best_evaluation());
}

TEST(KeptPoints, OfAMeterAreNoneWhereNothingIsHeldOut) {
  const toy::ToyProblem problem;
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), {});
  (void)meter.value(std::vector<double>{0.0, 0.0, 0.0});
  EXPECT_TRUE(meter.kept().empty());
}

}  // namespace
}  // namespace nodal
