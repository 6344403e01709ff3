// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/statistics/many_problems.h>

#include "never.h"

namespace nodal::statistics {
namespace {

// One method first, one second, one last on 4 problems: the largest χ² there is, N(k − 1) = 8, p = e^{−4}.
TEST(ManyProblems, OneOrderThroughoutIsTheLargestChiSquared) {
  const auto found = *friedman(Matrix(4, {1.0, 2.0, kNever}));
  EXPECT_EQ(found.ranks, (std::vector{1.0, 2.0, 3.0}));
  EXPECT_NEAR(found.chi_squared, 8.0, 1e-12);
  EXPECT_NEAR(found.p, std::exp(-4.0), 1e-12);
}

TEST(ManyProblems, EqualMethodsDoNotDiffer) {
  const auto found = *friedman(Matrix(3, {2.0, 2.0}));
  EXPECT_EQ(found.ranks, (std::vector{1.5, 1.5}));
  EXPECT_EQ(found.chi_squared, 0.0);
  EXPECT_EQ(found.p, 1.0);
}

TEST(ManyProblems, NothingIsSaidOfNothing) {
  EXPECT_FALSE(friedman({}));
  EXPECT_FALSE(friedman({{1.0}}));
  EXPECT_TRUE(performance_profile({}, std::vector{1.0}).empty());
  EXPECT_TRUE(data_profile({}, std::vector{1.0}).empty());
  EXPECT_THROW((void)friedman({{1.0, 2.0}, {1.0}}), std::invalid_argument);
}

TEST(ManyProblems, WhatNobodySolvesCountsForNobody) {
  const Matrix costs = {{kNever, kNever}, {1.0, 2.0}};
  EXPECT_EQ(performance_profile(costs, std::vector{1.0, 2.0}), (Matrix{{0.5, 0.5}, {0.0, 0.5}}));
  EXPECT_EQ(data_profile(costs, std::vector{1.0, kNever}), (Matrix{{0.5, 0.5}, {0.0, 0.5}}));
}

// Within a factor of 2 of the best, a has one problem and b none while c is there. Without it b has two and a one.
TEST(ManyProblems, AnOrderThatHangsOnAThirdMethodIsToldOf) {
  const Matrix costs = {{11.0, 5.0, 1.0}, {11.0, 5.0, 1.0}, {1.0, 3.0, 1.1}};
  const std::optional<ProfileWarning> warning = unstable_order(costs, std::vector{2.0});
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->left_out, 2u);
  EXPECT_EQ(warning->factor, 2.0);
  EXPECT_EQ(warning->first, 0u);
  EXPECT_EQ(warning->second, 1u);
  EXPECT_FALSE(unstable_order({{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}, std::vector{1.0, 2.0}));
  EXPECT_FALSE(unstable_order({{1.0, 2.0}}, std::vector{1.0}));
}

}  // namespace
}  // namespace nodal::statistics
