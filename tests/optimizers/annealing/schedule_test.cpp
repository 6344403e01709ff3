// SPDX-License-Identifier: GPL-3.0-or-later
// The schedule of Figure 6, pinned: temperatures, steps, moves, acceptance.
#include "schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "acceptance.h"
#include "annealing.h"
#include "move.h"

namespace nodal::annealing {
namespace {

TEST(Schedule, IsThePapersForThePlatesSeventyTwoSprings) {
  const Schedule schedule = make_schedule({}, 72, 42.9776);
  EXPECT_EQ(schedule.temperatures, 144);
  EXPECT_EQ(schedule.step_limit, 144);
  EXPECT_EQ(schedule.good_step_limit, 72);
  EXPECT_EQ(schedule.reduction, 0.98);
  EXPECT_DOUBLE_EQ(schedule.initial_temperature, 2e-4 * 42.9776);
}

// T ← T·r^i on entering temperature i: T_i = T₀·r^(i(i+1)/2), so T₀ and T₁ = T₀·r, not a plain geometric series.
TEST(Schedule, CoolsOverExponentially) {
  Temperature temperature({.initial_temperature = 3.0, .reduction = 0.98});
  for (int i = 0; i < 144; ++i) {
    const double expected = 3.0 * std::pow(0.98, 0.5 * i * (i + 1));
    EXPECT_NEAR(temperature.next() / expected, 1.0, 1e-12) << "temperature " << i;  // 144 products of rounded powers
  }
}

TEST(Acceptance, TakesEveryBetterStepWithoutADraw) {
  RandomStream drawn(1), untouched(1);
  EXPECT_EQ(judge(1.0, 0.9, 0.0, drawn), Verdict::good);
  EXPECT_EQ(drawn(), untouched());
}

// The temperature is the worsening that is accepted with probability 1/e. Over 40,000 draws the share's standard
// deviation is 0.0024; five of them bound it.
TEST(Acceptance, TakesAWorseningOfOneTemperatureThirtySevenPercentOfTheTime) {
  RandomStream random(7);
  int accepted = 0;
  for (int i = 0; i < 40000; ++i) accepted += judge(1.0, 1.25, 0.25, random) == Verdict::accepted_worse;
  EXPECT_NEAR(accepted / 40000.0, std::exp(-1.0), 5 * 0.0024);
}

TEST(Acceptance, TakesNoWorseStepAtZeroTemperature) {
  RandomStream random(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(judge(1.0, 1.0 + 1e-12, 0.0, random), Verdict::rejected);
}

TEST(Moves, AreReflectedAtTheBounds) {
  EXPECT_DOUBLE_EQ(reflect(1.25, -1.0, 1.0), 0.75);
  EXPECT_DOUBLE_EQ(reflect(-1.25, -1.0, 1.0), -0.75);
  EXPECT_DOUBLE_EQ(reflect(0.5, -1.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(reflect(3.5, -1.0, 1.0), -0.5);     // across the box and back
  EXPECT_DOUBLE_EQ(reflect(-8.75, -1.0, 1.0), -0.75);  // twice around
}

// Coordinates are chosen evenly and steps stay within ±s.
TEST(Moves, ChangeOneCoordinateByAtMostTheStep) {
  const Space space({{"a", -1.0, 1.0, 0.0}, {"b", -1.0, 1.0, 0.5}, {"c", -1.0, 1.0, 0.95}});
  const std::vector<double> current = {0.0, 0.5, 0.95};
  RandomStream random(3);
  std::vector<int> chosen(3, 0);
  for (int i = 0; i < 30000; ++i) {
    const Move move = propose_move(space, current, 0.2, random);
    ASSERT_LT(move.coordinate, 3u);
    ++chosen[move.coordinate];
    EXPECT_LE(std::abs(move.value - current[move.coordinate]), 0.2);
    EXPECT_LE(move.value, 1.0);
  }
  for (const int count : chosen) EXPECT_NEAR(count, 10000, 5 * 82);  // five standard deviations
}

}  // namespace
}  // namespace nodal::annealing
