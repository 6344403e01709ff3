// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include <nodal/statistics/order.h>

#include "never.h"

namespace nodal::statistics {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Order, QuantilesLieBetweenOrderStatistics) {
  EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.25), 1.75);
  EXPECT_EQ(quantile({5.0}, 0.9), 5.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.0), 1.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 1.0), 2.0);
}

TEST(Order, WhatNeverHappenedIsTheLargest) {
  EXPECT_EQ(quantile({kNever, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({kNever, 1.0}, 0.5), kNever);
  EXPECT_EQ(quantile({kNever, kNever}, 0.5), kNever);
  EXPECT_EQ(quantile({kNever, 1.0}, 0.0), 1.0);
}

TEST(Order, TiesShareTheirRanks) {
  EXPECT_EQ(mid_ranks(std::vector{10.0, 30.0, 10.0, 20.0, 10.0}), (std::vector{2.0, 5.0, 2.0, 4.0, 2.0}));
  EXPECT_EQ(mid_ranks(std::vector{kNever, 1.0, kNever}), (std::vector{2.5, 1.0, 2.5}));
  EXPECT_EQ(tie_term(std::vector{1.0, 1.0, 1.0, 2.0, 2.0, 3.0}), 24.0 + 6.0);
  EXPECT_EQ(tie_term(std::vector<double>{}), 0.0);
}

// Of n values the j-th from either end, with P(Bin(n, ½) < j) ≤ 0.025: tables of the sign test.
TEST(Order, AnIntervalOfTheMedianIsOfOrderStatistics) {
  std::vector<double> values;
  const auto ends = [&](std::size_t n) {
    values.clear();
    for (std::size_t i = n; i > 0; --i) values.push_back(static_cast<double>(i));
    return median_interval(values);
  };
  EXPECT_FALSE(ends(0));
  EXPECT_FALSE(ends(5));
  EXPECT_EQ(*ends(6), std::pair(1.0, 6.0));
  EXPECT_EQ(*ends(9), std::pair(2.0, 8.0));
  EXPECT_EQ(*ends(15), std::pair(4.0, 12.0));
  EXPECT_EQ(*ends(20), std::pair(6.0, 15.0));
  EXPECT_EQ(*ends(30), std::pair(10.0, 21.0));
  EXPECT_EQ(*ends(1075), std::pair(505.0, 571.0));  // where 0.5ⁿ is 0
  EXPECT_EQ(*ends(2000), std::pair(956.0, 1045.0));
  EXPECT_EQ(median_interval({1, 2, 3, kNever, kNever, kNever})->second, kNever);
  EXPECT_THROW((void)median_interval({1.0}, 1.0), std::invalid_argument);
}

TEST(Order, HasNoPlaceForNan) {
  EXPECT_THROW((void)quantile({1.0, kNan}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)mid_ranks(std::vector{kNan}), std::invalid_argument);
  EXPECT_THROW((void)quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)quantile({1.0}, 1.5), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::statistics
