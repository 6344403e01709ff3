// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/statistics/anytime.h>

#include "never.h"

namespace nodal::statistics {
namespace {

const std::vector<History> kThree = {{{1.0, 8.0}, {4.0, 2.0}}, {{2.0, 4.0}, {8.0, 1.0}}, {{1.0, 6.0}}};

TEST(Anytime, ATrialKeepsItsBest) {
  EXPECT_EQ(quality_at(kThree[0], 0.5), kNever);
  EXPECT_EQ(quality_at(kThree[0], 1.0), 8.0);
  EXPECT_EQ(quality_at(kThree[0], 3.9), 8.0);
  EXPECT_EQ(quality_at(kThree[0], 1e9), 2.0);
  EXPECT_EQ(quality_at({}, 1.0), kNever);
}

TEST(Anytime, AttainmentIsAShareOfTrials) {
  EXPECT_EQ(attainment(kThree, 1.0, 6.0), 1.0 / 3.0);
  EXPECT_EQ(attainment(kThree, 2.0, 8.0), 1.0);
  EXPECT_EQ(attainment(kThree, 8.0, 2.0), 2.0 / 3.0);
  EXPECT_EQ(attainment({}, 1.0, 1.0), 0.0);
}

void expect_surface(double share, const History& wanted) {
  const History found = attainment_surface(kThree, share);
  ASSERT_EQ(found.size(), wanted.size()) << share;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(found[i].cost, wanted[i].cost) << share;
    EXPECT_EQ(found[i].quality, wanted[i].quality) << share;
  }
}

TEST(Anytime, SurfacesAreKthBestQualities) {
  expect_surface(1.0 / 3.0, {{1.0, 6.0}, {2.0, 4.0}, {4.0, 2.0}, {8.0, 1.0}});
  expect_surface(2.0 / 3.0, {{1.0, 8.0}, {2.0, 6.0}, {4.0, 4.0}, {8.0, 2.0}});
  expect_surface(1.0, {{2.0, 8.0}, {4.0, 6.0}});
  EXPECT_EQ(attainment_surface(kThree, 1e-12).size(), 4u);
  EXPECT_TRUE(attainment_surface({}, 0.5).empty());
  EXPECT_TRUE(attainment_surface(std::vector<History>(2), 0.5).empty());
  EXPECT_THROW((void)attainment_surface(kThree, 0.0), std::invalid_argument);
}

// As they are defined, of histories in which costs and qualities coincide.
TEST(Anytime, SeveralSurfacesAtOnceAreThoseOfEach) {
  const std::vector<History> histories = {
      {{0.0, 9.0}, {2.0, 5.0}, {7.0, 1.0}}, {{0.0, 9.0}, {2.0, 4.0}, {3.0, 1.0}}, {{1.0, 5.0}, {2.0, 4.0}}, {}};
  const std::vector<double> shares = {0.25, 0.5, 0.75, 1.0};
  const std::vector<History> surfaces = attainment_surfaces(histories, shares);
  ASSERT_EQ(surfaces.size(), shares.size());
  for (std::size_t s = 0; s < shares.size(); ++s)
    for (const double cost : {0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 7.0, 9.0}) {
      std::vector<double> all;
      for (const History& history : histories) all.push_back(quality_at(history, cost));
      std::ranges::sort(all);
      EXPECT_EQ(quality_at(surfaces[s], cost), all[s]) << shares[s] << " at " << cost;
    }
  EXPECT_TRUE(surfaces[3].empty());
}

// On every surface the share of trials that are there is at least its own, and just before it, or just below, less.
TEST(Anytime, SurfacesAgreeWithAttainment) {
  for (const double share : {0.2, 1.0 / 3.0, 0.5, 2.0 / 3.0, 0.9, 1.0})
    for (const BestSoFar& point : attainment_surface(kThree, share)) {
      EXPECT_GE(attainment(kThree, point.cost, point.quality), share - 1e-12);
      EXPECT_LT(attainment(kThree, point.cost, std::nextafter(point.quality, 0.0)), share);
      EXPECT_LT(attainment(kThree, std::nextafter(point.cost, 0.0), point.quality), share);
    }
}

// From 1 to 1e4, gaps from 1 to 1e-8: at the largest for one decade of cost, half way down for another, at the smallest
// for two: under it lie 1 + ½ of 4.
TEST(Anytime, AreaOverAConvergenceCurve) {
  const AnytimeLimits limits{1.0, 1e4};
  EXPECT_NEAR(area_over_convergence({{0.5, 1.0}, {10.0, 1e-4}, {100.0, 1e-9}}, limits), 1.0 - 1.5 / 4.0, 1e-12);
  EXPECT_NEAR(area_over_convergence({{10.0, 0.0}}, limits), 0.75, 1e-12);
  EXPECT_EQ(area_over_convergence({}, limits), 0.0);
  EXPECT_EQ(area_over_convergence({{2e4, 0.0}}, limits), 0.0);
  EXPECT_EQ(area_over_convergence({{1.0, 1e-8}}, limits), 1.0);
  EXPECT_EQ(area_over_convergence({{0.0, 1.0}, {3.0, 1.0}, {7.0, 1.0}, {4901.0, 1.0}}, limits), 0.0);
  EXPECT_THROW((void)area_over_convergence({}, {1.0, 1.0}), std::invalid_argument);
  EXPECT_THROW((void)area_over_convergence({}, {0.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::statistics
