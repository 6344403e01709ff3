// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/random.h>
#include <nodal/statistics/run_length.h>

namespace nodal::statistics {
namespace {

TEST(RunLengths, FailuresCostUntilTheirEnd) {
  const std::vector<RunLength> trials = {{1.0, 9.0}, {{}, 10.0}, {3.0, 3.0}};
  EXPECT_EQ(expected_running_time(trials), 7.0);  // (1 + 10 + 3)/2
}

TEST(RunLengths, WithoutTrialsOrSuccessesThereIsNoFigure) {
  const std::vector<RunLength> failed = {{{}, 10.0}, {{}, 20.0}};
  EXPECT_FALSE(expected_running_time({}));
  EXPECT_FALSE(expected_running_time(failed));
  EXPECT_FALSE(bootstrap_running_time({}, 1));
  const Interval interval = *bootstrap_running_time(failed, 1);
  EXPECT_FALSE(interval.lower);
  EXPECT_FALSE(interval.upper);
  EXPECT_FALSE(success_rate({}));
  EXPECT_EQ(success_rate(failed)->rate, 0.0);
  EXPECT_TRUE(distribution({}).empty());
  EXPECT_TRUE(distribution(failed).empty());
}

// Exponential run lengths that all succeed: the ERT is their mean m, with a standard error of s/√n, so that the normal
// interval is m ± 1.96 s/√n. The bootstrap's is as wide but for its own noise and skewness, of some per cent of it.
TEST(RunLengths, TheBootstrapCoversTheAnalyticInterval) {
  constexpr std::size_t kTrials = 400;
  RandomStream random(3);
  std::vector<RunLength> trials;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < kTrials; ++i) {
    const double length = -std::log(1.0 - random.uniform());
    trials.push_back({length, length + 1.0});
    sum += length;
    squares += length * length;
  }
  const double n = kTrials, mean = sum / n;
  const double half = 1.959964 * std::sqrt((squares / n - mean * mean) / n);
  const Interval interval = *bootstrap_running_time(trials, 7, 4000);
  EXPECT_NEAR(*interval.lower, mean - half, 0.1 * half);
  EXPECT_NEAR(*interval.upper, mean + half, 0.1 * half);
}

// Each drawing of 2 of one success (1 s) and one failure (4 s) is as likely: ss 1, sf and fs 5, ff never.
TEST(RunLengths, ADrawingWithoutSuccessIsInfinite) {
  const std::vector<RunLength> trials = {{1.0, 1.0}, {{}, 4.0}};
  const Interval wide = *bootstrap_running_time(trials, 1, 2000, 0.9);  // 5 % and 95 %
  EXPECT_EQ(wide.lower, 1.0);
  EXPECT_FALSE(wide.upper);
  const Interval middle = *bootstrap_running_time(trials, 1, 2000, 0.3);  // 35 % and 65 %
  EXPECT_EQ(middle.lower, 5.0);
  EXPECT_EQ(middle.upper, 5.0);
}

TEST(RunLengths, TheBootstrapHangsOnItsSeedAlone) {
  const std::vector<RunLength> trials = {{1.0, 1.0}, {2.0, 2.0}, {{}, 4.0}, {2.5, 3.0}, {0.25, 1.0}};
  const Interval first = *bootstrap_running_time(trials, 11), again = *bootstrap_running_time(trials, 11);
  EXPECT_EQ(first.lower, again.lower);
  EXPECT_EQ(first.upper, again.upper);
}

// At p = ½ of n = 4 and z = 1.96: [½ + z²/8 ± z√(1/16 + z²/64)]/(1 + z²/4), by hand.
TEST(RunLengths, WilsonsInterval) {
  const SuccessRate half = *success_rate(2, 4);
  EXPECT_NEAR(half.lower, 0.1500389, 1e-6);
  EXPECT_NEAR(half.upper, 0.8499611, 1e-6);
  EXPECT_NEAR(success_rate(0, 3)->lower, 0.0, 1e-15);
  EXPECT_NEAR(success_rate(3, 3)->upper, 1.0, 1e-15);
  EXPECT_LT(success_rate(3, 3)->lower, 0.5);  // three of three proves little
  EXPECT_THROW((void)success_rate(4, 3), std::invalid_argument);
  EXPECT_THROW((void)success_rate(1, 3, 1.0), std::invalid_argument);
}

TEST(RunLengths, DistributionStepsWhereSomethingIsReached) {
  const std::vector<RunLength> trials = {{2.0, 5.0}, {{}, 5.0}, {1.0, 5.0}, {2.0, 5.0}};
  const std::vector<Step> steps = distribution(trials);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].at, 1.0);
  EXPECT_EQ(steps[0].share, 0.25);
  EXPECT_EQ(steps[1].at, 2.0);
  EXPECT_EQ(steps[1].share, 0.75);
}

}  // namespace
}  // namespace nodal::statistics
