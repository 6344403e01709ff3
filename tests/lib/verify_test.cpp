// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/verify.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

using Way = std::vector<std::pair<std::int64_t, double>>;
const Way kWay = {{2, 9.0}, {40, 7.0}, {90, 6.0}};

std::string difference(const TrialRecord& a, const TrialRecord& b, double tolerance = 0.0) {
  return same_trial(a, b, tolerance).difference;
}

TEST(SameTrial, IsToTheLastBit) {
  Way other = kWay;
  const SameTrial same = same_trial(trial("a", 0, kWay), trial("a", 0, kWay), 0.0);
  EXPECT_EQ(same.difference, "");
  EXPECT_EQ(same.points, 4);  // with the start
  EXPECT_EQ(same.evaluations, 100);
  other[1].second = std::nextafter(7.0, 8.0);
  EXPECT_EQ(difference(trial("a", 0, kWay), trial("a", 0, other)),
            "at evaluation 40 the quality was 7, now it is 7.000000000000001");
  EXPECT_EQ(difference(trial("a", 0, kWay), trial("a", 0, other), kAcrossMachines), "");
  other[1].second = 7.0001;
  EXPECT_NE(difference(trial("a", 0, kWay), trial("a", 0, other), kAcrossMachines), "");
}

TEST(SameTrial, FindsPointsThatOneHasOnly) {
  Way other = kWay;
  other.insert(other.begin() + 1, {30, 8.0});
  EXPECT_EQ(difference(trial("a", 0, kWay), trial("a", 0, other)),
            "a better point at evaluation 30 was found now only");
  EXPECT_EQ(difference(trial("a", 0, other), trial("a", 0, kWay)),
            "a better point at evaluation 30 was found then only");
  EXPECT_EQ(difference(trial("a", 0, kWay), trial("a", 0, {{2, 9.0}, {40, 7.0}})),
            "a better point at evaluation 90 was found then only");
}

TEST(SameTrial, GoesAsFarAsTheShorterOne) {
  const TrialRecord longer = trial("a", 0, kWay), shorter = trial("a", 0, {{2, 9.0}, {40, 7.0}}, 60);
  EXPECT_EQ(difference(longer, shorter), "");
  EXPECT_EQ(difference(shorter, longer), "");
  EXPECT_EQ(same_trial(longer, shorter, 0.0).points, 3);
  EXPECT_NE(difference(longer, trial("a", 0, {{2, 9.0}, {41, 7.0}}, 60)), "");
}

TEST(SameTrial, EndsInOnePlaceAndOneWay) {
  TrialRecord a = trial("a", 0, kWay), b = a;
  b.best->x = {1.0};
  EXPECT_NE(difference(a, b), "");
  b = a;
  b.end = End::finished;
  EXPECT_NE(difference(a, b), "");
  b.end = End::crashed;
  b.reason = "signal 11";
  EXPECT_EQ(difference(a, b), "it ended 'budget', now it ended 'crashed': signal 11");
}

// Two traces that were thinned at different lengths keep different points.
TEST(SameTrial, OfThinnedTracesWhatBothHaveIsCompared) {
  Way all, some;
  for (int i = 1; i <= 3000; ++i) all.push_back({2 * i, 10.0 - 0.001 * i});
  for (std::size_t i = 0; i < all.size(); i += 2) some.push_back(all[i]);
  EXPECT_EQ(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)), "");
  some[700].second -= 1e-6;
  EXPECT_NE(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)), "");
}

}  // namespace
}  // namespace nodal
