// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/convergence.h>

#include <gtest/gtest.h>

#include <cmath>

#include "verdict_trials.h"

namespace nodal {
namespace {

constexpr std::size_t kSeconds = 0, kEvaluations = 1;

ProblemConvergence converge_of(const Race& race, std::optional<KnownOptimum> known = {},
                               std::optional<double> evaluations = {}) {
  Contest contest = race.contest();
  const std::vector<TrialRecord> records(race.records.begin(), race.records.end());
  if (!known) known = KnownOptimum{race.best, "given", {}};
  const ProblemTable table = make_table("p", known, race.optimizers, records);
  contest.reference = table.reference;
  return converge(contest, table, {}, evaluations);
}

const TargetFigures& target(const ConvergenceFigures& figures, double gap) {
  return *std::ranges::find(figures.targets, gap, &TargetFigures::gap);
}

// From 11 to 1: a gap of 0.1 is quality 2.
TEST(Convergence, ExpectsAllCostsOverSuccesses) {
  Race race;
  race.add(trial("a", 0, {{20, 2.0}}));
  race.add(trial("a", 1, {{40, 1.5}}));
  race.add(trial("a", 2, {{10, 5.0}}));
  const ProblemConvergence found = converge_of(race);
  const TargetFigures& tenth = target(found.optimizers.at(0), 0.1);
  EXPECT_DOUBLE_EQ(*tenth.expected[kEvaluations], (20.0 + 40.0 + 100.0) / 2.0);
  EXPECT_DOUBLE_EQ(*tenth.expected[kSeconds], (2.0 + 4.0 + 10.0) / 2.0);
  EXPECT_EQ(tenth.success->successes, 2u);
  EXPECT_EQ(tenth.success->trials, 3u);
  ASSERT_TRUE(tenth.interval[kEvaluations]);
  EXPECT_LE(*tenth.interval[kEvaluations]->lower, 80.0);
  EXPECT_GE(tenth.interval[kEvaluations]->upper.value_or(1e9), 80.0);
  const TargetFigures& hundredth = target(found.optimizers.at(0), 0.01);
  EXPECT_FALSE(hundredth.expected[kEvaluations]);
  EXPECT_FALSE(hundredth.interval[kEvaluations]);
  EXPECT_EQ(hundredth.success->successes, 0u);
}

TEST(Convergence, IntervalsAreTheSameAtEveryCall) {
  Race race;
  for (int repeat = 0; repeat < 9; ++repeat) race.add(trial("a", repeat, {{10 + 7 * repeat, 1.5}}));
  const auto once = converge_of(race), again = converge_of(race);
  const auto interval = [](const ProblemConvergence& found) {
    const statistics::Interval& at = *target(found.optimizers.at(0), 0.1).interval[kEvaluations];
    return std::pair(*at.lower, *at.upper);
  };
  EXPECT_EQ(interval(once), interval(again));
  EXPECT_LT(interval(once).first, 38.0);  // the mean
  EXPECT_GT(interval(once).second, 38.0);
}

TEST(Convergence, EqualTrialsHaveAnIntervalOfNoWidth) {
  Race race;
  race.add(trial("a", 0, {{20, 1.0}}));
  const TargetFigures only = target(converge_of(race).optimizers.at(0), 0.1);
  EXPECT_EQ(only.interval[kEvaluations]->lower, 20.0);
  EXPECT_EQ(only.interval[kEvaluations]->upper, 20.0);
}

TEST(Convergence, ATrialThatDiedHasCostAsMuchAsTheLongest) {
  Race race;
  race.add(trial("a", 0, {{20, 1.0}}));
  TrialRecord& dead = race.add(trial("a", 1, {}, 0));
  dead.end = End::crashed;
  dead.start = {};
  dead.best = {};
  dead.trace.clear();
  EXPECT_DOUBLE_EQ(*target(converge_of(race).optimizers.at(0), 0.1).expected[kEvaluations], 20.0 + 100.0);
}

// It had no processor time to tell of, and still isn't a disturbed one.
TEST(Convergence, ATrialThatWasKilledHasCostItsOwnSeconds) {
  Race race;
  race.add(trial("a", 0, {{20, 1.0}}));
  TrialRecord& dead = race.add(trial("a", 1, {}, 0));
  dead.end = End::timeout;
  dead.start = {};
  dead.best = {};
  dead.trace.clear();
  dead.seconds = {.total = 35.0};
  race.add(trial("b", 0, {}));
  const ProblemConvergence found = converge_of(race);
  EXPECT_TRUE(contamination(dead).empty());
  EXPECT_DOUBLE_EQ(*target(found.optimizers.at(0), 0.1).expected[kSeconds], 2.0 + 35.0);
  EXPECT_DOUBLE_EQ(*target(found.optimizers.at(0), 0.1).expected[kEvaluations], 20.0 + 100.0);
  EXPECT_DOUBLE_EQ(found.limits[kSeconds]->to, 10.0);
  // What an older version stored has no seconds.
  dead.seconds = {};
  EXPECT_DOUBLE_EQ(*target(converge_of(race).optimizers.at(0), 0.1).expected[kSeconds], 2.0 + 10.0);
}

TEST(Convergence, DisturbedTimesDontCountAsLongAsThereAreOthers) {
  Race race;
  race.add(trial("a", 0, {{20, 1.0}}));
  race.add(trial("a", 1, {{40, 1.0}})).seconds.cpu = 0.1;
  const ConvergenceFigures figures = converge_of(race).optimizers.at(0);
  EXPECT_DOUBLE_EQ(*target(figures, 0.1).expected[kSeconds], 2.0);
  EXPECT_DOUBLE_EQ(*target(figures, 0.1).expected[kEvaluations], 30.0);
}

// 1.0 was given with one digit: 0.5 of it, at most 1e-4, over the span of 10.
TEST(Convergence, RefusesTargetsThatNobodyKnowsWellEnough) {
  Race race;
  race.add(trial("a", 0, {{20, 1.0}}));
  const ProblemConvergence found = converge_of(race);
  EXPECT_DOUBLE_EQ(found.least_gap, 1e-5);
  EXPECT_EQ(found.refused, (std::vector<double>{1e-6, 1e-7, 1e-8}));
  EXPECT_EQ(found.optimizers.at(0).targets.size(), 5u);
  // Known to eight digits, it can be asked for more.
  race.best = 0.99999999;
  EXPECT_NEAR(converge_of(race).least_gap, 5e-10, 1e-12);
  EXPECT_TRUE(converge_of(race).refused.empty());
}

TEST(Convergence, AreaByHand) {
  Race race;
  // Gap 1 until evaluation 10, then 1e-4, to 100: of two decades the second is half-way down.
  race.best = 0.0;
  race.add(trial("a", 0, {{10, 11e-4}}));
  EXPECT_NEAR(*converge_of(race).optimizers.at(0).area[kEvaluations], 0.25, 1e-12);
  EXPECT_NEAR(*converge_of(race, {}, 1000.0).optimizers.at(0).area[kEvaluations], 2.0 / 3.0 * 0.5, 1e-12);
}

TEST(Convergence, HasSurfacesAndRunLengths) {
  Race race;
  race.add(trial("a", 0, {{10, 6.0}}));
  race.add(trial("a", 1, {{20, 4.0}}));
  const ConvergenceFigures figures = converge_of(race).optimizers.at(0);
  const statistics::History& half = figures.attained[kEvaluations][1];
  ASSERT_EQ(half.size(), 3u);  // one of two is enough: 11, 6, 4
  EXPECT_DOUBLE_EQ(half[1].cost, 10.0);
  EXPECT_DOUBLE_EQ(half[1].quality, 6.0);
  EXPECT_DOUBLE_EQ(half[2].quality, 4.0);
  EXPECT_DOUBLE_EQ(figures.attained[kEvaluations][2].back().quality, 6.0);
  EXPECT_EQ(figures.lengths[kEvaluations].size(), 2u * 5u);
}

// A third of a thousand steps is passed after a third of them: nothing between is left out.
TEST(Convergence, SurfacesAreWhole) {
  Race race;
  for (int repeat = 0; repeat < 4; ++repeat) {
    std::vector<std::pair<std::int64_t, double>> way;
    for (int i = 1; i <= 1000; ++i) way.emplace_back((repeat + 1) * i, 11.0 - 0.01 * i);
    race.add(trial("a", repeat, way, 4000));
  }
  const std::vector<statistics::History> attained = converge_of(race).optimizers.at(0).attained[kEvaluations];
  ASSERT_EQ(attained.size(), kAttainedShares.size());
  for (std::size_t share = 0; share < attained.size(); ++share) {
    EXPECT_EQ(attained[share].size(), 1001u);
    EXPECT_DOUBLE_EQ(statistics::quality_at(attained[share], 333.0 * static_cast<double>(share + 1)), 11.0 - 3.33);
  }
}

TEST(Convergence, NobodyImprovedHasNoArea) {
  Race race;
  race.add(trial("a", 0, {}));
  Contest contest = race.contest();
  const std::vector<TrialRecord> records(race.records.begin(), race.records.end());
  const ProblemTable table = make_table("p", {}, race.optimizers, records);
  contest.reference = table.reference;
  ASSERT_TRUE(table.reference.unimproved);
  const ProblemConvergence found = converge(contest, table);
  for (const auto& limits : found.limits) EXPECT_FALSE(limits);
  for (const auto& area : found.optimizers.at(0).area) EXPECT_FALSE(area);
}

// 11 is all that there is to reach: everything is at the smallest gap from the first cost on.
TEST(Convergence, WhatStartsAtTheBestHasTheWholeArea) {
  Race race;
  race.best = 11.0;
  race.add(trial("a", 0, {}));
  EXPECT_EQ(*converge_of(race).optimizers.at(0).area[kEvaluations], 1.0);
  EXPECT_EQ(*converge_of(race).optimizers.at(0).area[kSeconds], 1.0);
}

TEST(Convergence, OfNothingThereIsNothing) {
  Race race;
  race.optimizers = {{"a", "a"}};
  EXPECT_TRUE(converge_of(race).optimizers.empty());
  EXPECT_EQ(converge_of(race).least_gap, 0.0);
}

TEST(Convergence, AllFailedHasFiguresOfNothing) {
  Race race;
  for (int repeat = 0; repeat < 2; ++repeat) {
    TrialRecord& dead = race.add(trial("a", repeat, {}, 0));
    dead.end = End::crashed;
    dead.start = {};
    dead.best = {};
    dead.trace.clear();
    dead.seconds.total = 0.0;
  }
  const ConvergenceFigures figures = converge_of(race).optimizers.at(0);
  EXPECT_FALSE(target(figures, 0.1).expected[kEvaluations]);
  EXPECT_EQ(target(figures, 0.1).success->rate, 0.0);
  EXPECT_FALSE(figures.area[kEvaluations]);
  EXPECT_TRUE(figures.attained[kEvaluations][1].empty());
}

}  // namespace
}  // namespace nodal
