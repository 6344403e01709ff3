// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/verify.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

using Way = std::vector<std::pair<std::int64_t, double>>;
const Way kWay = {{2, 9.0}, {40, 7.0}, {90, 6.0}};

std::string difference(const TrialRecord& a, const TrialRecord& b, double tolerance = 0.0, bool timed = true) {
  return same_trial(a, b, tolerance, timed).difference;
}

TEST(SameTrial, IsToTheLastBit) {
  Way other = kWay;
  const SameTrial same = same_trial(trial("a", 0, kWay), trial("a", 0, kWay), 0.0, false);
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
  EXPECT_EQ(same_trial(longer, shorter, 0.0, true).points, 3);
  EXPECT_NE(difference(longer, trial("a", 0, {{2, 9.0}, {41, 7.0}}, 60)), "");
  EXPECT_EQ(difference(shorter, longer, 0.0, false), "it ended after 60 evaluations, now after 100");
  TrialRecord finished = shorter;
  finished.end = End::finished;
  EXPECT_EQ(difference(finished, longer), "it ended after 60 evaluations, now after 100");
}

// Each figure that the clock has no part in.
TEST(SameTrial, HasTheWholeRecord) {
  const TrialRecord honest = trial("a", 0, kWay);
  const auto forged = [&](auto forge, double tolerance = 0.0) {
    TrialRecord record = honest;
    forge(record);
    return difference(record, honest, tolerance, false);
  };
  EXPECT_EQ(forged([](TrialRecord& r) { r.best->summary.cost = 0.5; }), "best.cost was 0.5, now it is 1");
  EXPECT_EQ(forged([](TrialRecord& r) { r.best->summary.cost = 0.5; }, 1e-9), "best.cost was 0.5, now it is 1");
  EXPECT_EQ(forged([](TrialRecord& r) { r.start.quality = 12.0; }), "start.quality was 12, now it is 11");
  EXPECT_EQ(forged([](TrialRecord& r) { r.counts.values = 7; }), "counts.values was 7, now it is 0");
  EXPECT_EQ(forged([](TrialRecord& r) { r.counts.values = 7; }, 1e-9), "counts.values was 7, now it is 0");
  EXPECT_EQ(forged([](TrialRecord& r) { r.work.flops = 5.0; }), "work.flops was 5, now it is 0");
  EXPECT_EQ(forged([](TrialRecord& r) { r.optimizer = "b"; }), "optimizer was \"b\", now it is \"a\"");
  EXPECT_EQ(forged([](TrialRecord& r) { r.claimed = ClaimRecord{0.1, {}, {}, "done"}; }).substr(0, 7), "claimed");
  EXPECT_EQ(forged([](TrialRecord& r) {
              r.attempt = 3;
              r.seconds.total = 77.0;
              r.trace[1].seconds = 0.5;
              r.conditions.emplace();
            }),
            "");
}

TEST(SameTrial, AgreesWithItself) {
  const TrialRecord longer = trial("a", 0, kWay);
  TrialRecord forged = trial("a", 0, {{2, 9.0}, {40, 7.0}}, 60);
  forged.best->summary.quality = 0.001;
  EXPECT_EQ(difference(forged, longer), "the record has a best of quality 0.001, its trace ends at 7");
  forged.best->summary.quality = 7.0 * (1.0 + 1e-5);
  EXPECT_NE(difference(forged, longer), "");
  forged.health.drift = 1e-4;  // the audit found as much
  EXPECT_EQ(difference(forged, longer), "");
  forged.best->evaluation = 2;
  EXPECT_EQ(difference(forged, longer), "the record has its best from evaluation 2, its trace ends at 40");
  forged = trial("a", 0, kWay);
  forged.counts.evaluations = 0;
  EXPECT_EQ(difference(forged, longer), "the record has 0 evaluations, and a point at evaluation 90");
}

TEST(SameTrial, IsNotCheckedWhereOnlyTheStartIsCompared) {
  const TrialRecord longer = trial("a", 0, kWay);
  const SameTrial none = same_trial(trial("a", 0, {}, 0), longer, 0.0, true);
  EXPECT_EQ(none.difference, "");
  EXPECT_FALSE(none.checked);
  const SameTrial nothing_better = same_trial(trial("a", 0, {}, 1), longer, 0.0, true);
  EXPECT_TRUE(nothing_better.checked);  // neither had found a better point by then
  EXPECT_TRUE(same_trial(longer, longer, 0.0, true).checked);
  TrialRecord killed = trial("a", 0, {}, 0);
  killed.end = End::timeout;
  killed.trace.clear();
  EXPECT_FALSE(same_trial(killed, killed, 0.0, false).checked);
}

// Of two that the clock ended at one evaluation the other may have been given a product more.
TEST(SameTrial, EndedByTheClockHasItsBestCompared) {
  const TrialRecord a = trial("a", 0, kWay);
  TrialRecord b = a;
  b.counts.products = 4;
  EXPECT_EQ(difference(a, b), "");
  EXPECT_NE(difference(a, b, 0.0, false), "");
  b.best->summary.relative_error = 0.4;
  EXPECT_EQ(difference(a, b), "best.relative_error was 0.5, now it is 0.4");
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
  for (std::size_t i = 1; i < all.size(); i += 2) some.push_back(all[i]);
  EXPECT_EQ(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)), "");
  some[700].second -= 1e-6;
  EXPECT_NE(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)), "");
  some.erase(some.begin() + 700);
  EXPECT_EQ(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)), "");
  some.insert(some.begin() + 700, {2801, 8.5});  // better than what was found later
  EXPECT_EQ(difference(trial("a", 0, all, 7000), trial("a", 0, some, 6500)),
            "a better point at evaluation 2801 was found now only");
}

TEST(SameTrial, WhatIsFoundWhileTheClockRunsOutDoesntCount) {
  const TrialRecord longer = trial("a", 0, kWay), shorter = trial("a", 0, {{2, 9.0}}, 40);
  EXPECT_EQ(difference(longer, shorter), "");
  EXPECT_EQ(difference(shorter, longer), "");
  EXPECT_NE(difference(longer, trial("a", 0, {{2, 9.0}}, 41)), "");
}

TEST(SameTrial, OfAValidatedStopEndsThere) {
  TrialRecord stopped = trial("a", 0, {{2, 9.0}}, 50);
  stopped.unseen = UnseenRecord{{"x", "y"}, {}, 0, ValidatedStop{2, 40, 7.0}};
  EXPECT_EQ(difference(stopped, trial("a", 0, kWay)), "");
  EXPECT_EQ(same_trial(stopped, trial("a", 0, kWay), 0.0, true).evaluations, 2);
}

}  // namespace
}  // namespace nodal
