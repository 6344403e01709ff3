// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verdict.h>

#include <gtest/gtest.h>

#include <nodal/statistics/two_samples.h>

#include "verdict_trials.h"

namespace nodal {
namespace {

using Labels = std::vector<std::string>;

const std::vector<double> kLow = {2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7},
                          kHigh = {5.0, 5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7};

TEST(Verdict, TakesTheLeastMedianAndSaysHowSureItIs) {
  Race race;
  race.add_all("worse", kHigh);
  race.add_all("better", kLow);
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_FALSE(verdict.nobody);
  EXPECT_TRUE(verdict.improved);
  EXPECT_EQ(taken(verdict), Labels{"better"});
  const Standing& first = verdict.standings.at(0);
  EXPECT_EQ(first.relation, Relation::first);
  EXPECT_DOUBLE_EQ(*first.quality.median, 2.35);
  EXPECT_DOUBLE_EQ(*first.quality.lower, 2.175);
  // Eight values: P(Bin(8, ½) < 1) = 1/256 and P(… < 2) = 9/256 > 0.025.
  EXPECT_DOUBLE_EQ(*first.median_interval.lower, 2.0);
  EXPECT_DOUBLE_EQ(*first.median_interval.upper, 2.7);
  ASSERT_NE(verdict.next(), nullptr);
  const Standing& next = *verdict.next();
  EXPECT_EQ(next.optimizer, "worse");
  EXPECT_EQ(next.test, PairTest::mann_whitney);  // all begin at one start: independent
  EXPECT_EQ(next.pairs, 8u);
  EXPECT_DOUBLE_EQ(*next.p, statistics::mann_whitney(kHigh, kLow)->p);
  EXPECT_DOUBLE_EQ(*next.effect, 1.0);
  EXPECT_FALSE(next.few);  // gaps 1.35 and 4.35
}

TEST(Verdict, AdjustsForAllPairsThatAreTested) {
  Race race;
  race.add_all("a", kLow);
  race.add_all("b", kHigh);
  race.add_all("c", {8.0, 8.1, 8.2, 8.3, 8.4, 8.5, 8.6, 8.7});
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(verdict.tests, 3u);
  // All three are separated in full, so that their p are the same, and Holm makes three times of it.
  EXPECT_DOUBLE_EQ(*standing(verdict, "c").p, 3.0 * statistics::mann_whitney(kHigh, kLow)->p);
}

TEST(Verdict, NamesWhoCantBeToldFromTheFirst) {
  Race race;
  race.add_all("a", {2.0, 2.2, 2.4, 2.6, 2.8, 3.0, 3.2, 3.4});
  race.add_all("b", {2.1, 2.3, 2.5, 2.7, 2.9, 3.1, 3.3, 3.5});
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(standing(verdict, "b").relation, Relation::untold);
  EXPECT_EQ(taken(verdict), (Labels{"a", "b"}));
  EXPECT_EQ(verdict.next(), nullptr);
}

TEST(Verdict, ComparesPairsWhereStartsAreShared) {
  Race race;
  // b is worse by a little from every start, which only pairs show: the starts differ far more.
  const std::vector<double> a = {2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
  std::vector<double> b = a;
  for (std::size_t i = 0; i < b.size(); ++i) b[i] += 0.1 + 0.01 * static_cast<double>(i);
  race.add_all("a", a, true);
  race.add_all("b", b, true);
  const Verdict verdict = judge(race.contest(), kWhole);
  const Standing& second = standing(verdict, "b");
  EXPECT_EQ(second.test, PairTest::wilcoxon);
  EXPECT_DOUBLE_EQ(*second.p, 2.0 / 256.0);  // all eight signs are one
  EXPECT_EQ(second.relation, Relation::told);
  EXPECT_TRUE(second.few);  // gaps 4.5 and 4.635, by eight
}

// b is worse from every start, but the clock was disturbed where it is hard for both.
TEST(Verdict, ComparesMediansOverTheStartsThatAllHave) {
  Race race;
  std::vector<double> a, b;
  for (int i = 0; i < 10; ++i) {
    a.push_back(2.0 + 0.8 * i);
    b.push_back(a.back() + 0.1 + 0.01 * i);
  }
  race.add_all("b", b, true);
  race.add_all("a", a, true);
  for (TrialRecord& record : race.records)
    if (record.optimizer == "b" && record.repeat >= 7) record.seconds.cpu = 0.1 * record.seconds.total;
  Verdict verdict = judge(race.contest(), {Axis::seconds, 100.0});
  EXPECT_EQ(taken(verdict), Labels{"a"});
  EXPECT_DOUBLE_EQ(*standing(verdict, "a").quality.median, a[3]);  // of repeats 0 … 6
  EXPECT_DOUBLE_EQ(*standing(verdict, "b").quality.median, b[3]);
  EXPECT_EQ(standing(verdict, "a").observations, 7u);
  EXPECT_EQ(standing(verdict, "b").relation, Relation::told);
  EXPECT_DOUBLE_EQ(*standing(verdict, "b").p, 2.0 / 128.0);
  EXPECT_EQ(standing(judge(race.contest(), kWhole), "a").observations, 10u);
  // One start is less than half of ten: each has its own.
  race.add_all("stopped", {2.0}, true);
  EXPECT_EQ(standing(judge(race.contest(), kWhole), "a").observations, 10u);
}

// From eleven of twelve starts b is better by a little, from one a by far, which moves both medians. W is 12 then, and
// 70 of 2¹² sets of signs have that or less. Of 144 pairs b is worse in 78: 55 of different starts but the one, 11 with
// a's there, 12 with its own.
TEST(Verdict, ATestAgainstTheMediansIsSaidAndSoIsItsDirection) {
  Race race;
  std::vector<double> a = {2.0}, b = {10.0};
  for (int i = 1; i < 12; ++i) {
    b.push_back(2.0 + 0.4 * i);
    a.push_back(b.back() + 0.01 * i);
  }
  race.add_all("a", a, true);
  race.add_all("b", b, true);
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(taken(verdict), (Labels{"a", "b"}));
  const Standing& second = standing(verdict, "b");
  EXPECT_EQ(second.relation, Relation::contrary);
  EXPECT_DOUBLE_EQ(*second.p, 140.0 / 4096.0);
  EXPECT_DOUBLE_EQ(*second.effect, 78.0 / 144.0);
  EXPECT_EQ(verdict.next(), nullptr);
}

// All differences are a half, but for the last bits of some: ties, of which the normal approximation with
// T = 8³ − 8 has z = 18/√(51 − 10.5).
TEST(Verdict, RoundingPartsNoTies) {
  Race race;
  const std::vector<double> a = {2.5, 2.6, 2.7, 2.8, 2.9, 3.1, 3.2, 3.3};
  std::vector<double> b = a;
  for (double& quality : b) quality += 0.5;
  race.add_all("a", a, true);
  race.add_all("b", b, true);
  EXPECT_NEAR(*standing(judge(race.contest(), kWhole), "b").p, 0.004678, 1e-6);
}

TEST(Verdict, OneWayFromOneStartIsOneObservationAndNoTest) {
  Race race;
  race.add_all("det", {2.0, 2.0, 2.0});
  race.set_deterministic("det");
  race.add_all("other", {3.0, 3.0, 3.0});
  race.set_deterministic("other");
  // Not deterministic, but all found the same at the same evaluation.
  race.add_all("same way", {4.0, 4.0, 4.0});
  race.add_all("random", kHigh);
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(standing(verdict, "det").trials, 3u);
  EXPECT_EQ(standing(verdict, "det").observations, 1u);
  EXPECT_EQ(standing(verdict, "same way").observations, 1u);
  EXPECT_EQ(standing(verdict, "random").observations, 8u);
  EXPECT_EQ(verdict.tests, 0u);
  EXPECT_EQ(taken(verdict), Labels{"det"});
  for (const char* label : {"other", "same way", "random"}) {
    EXPECT_EQ(standing(verdict, label).relation, Relation::untested) << label;
    EXPECT_FALSE(standing(verdict, label).p) << label;
  }
}

TEST(Verdict, DeterministicFromManyStartsIsAnObservationEach) {
  Race race;
  race.add_all("det", kLow, true);
  race.set_deterministic("det");
  EXPECT_EQ(judge(race.contest(), kWhole).standings.at(0).observations, 8u);
}

// Of equal digits the one that is there first.
TEST(Verdict, EqualDigitsAreATie) {
  Race race;
  race.add_all("slow", {2.00001, 2.00002, 2.00003, 2.00004}, false, 90);
  race.add_all("quick", {2.00011, 2.00012, 2.00013, 2.00014}, false, 10);
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(taken(verdict), (Labels{"quick", "slow"}));
  EXPECT_DOUBLE_EQ(*verdict.standings.at(0).cost, 10.0);
  EXPECT_DOUBLE_EQ(*verdict.standings.at(1).cost, 90.0);
  EXPECT_EQ(verdict.standings.at(1).relation, Relation::equal);
  EXPECT_DOUBLE_EQ(*verdict.standings.at(1).p, 1.0);
}

// Rounding above a perfect fit: fifteen orders of magnitude, and one result.
TEST(Verdict, EqualWithinNoiseIsATie) {
  Race race;
  race.best = 0.0;
  race.add_all("a", {1e-15, 2e-15, 3e-15});
  race.add_all("b", {1e-9, 2e-9, 3e-9});
  race.add_all("c", {1e-7, 2e-7, 3e-7});
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(taken(verdict).size(), 3u);  // three each tell nothing apart
  EXPECT_EQ(standing(verdict, "b").relation, Relation::equal);
  EXPECT_EQ(standing(verdict, "c").relation, Relation::untold);
}

TEST(Verdict, LooksAtWhatWasFoundWithinTheBudget) {
  Race race;
  for (int repeat = 0; repeat < 3; ++repeat) {
    race.add(trial("quick", repeat, {{5, 4.0 + 0.01 * repeat}}));
    race.add(trial("thorough", repeat, {{5, 6.0}, {80, 2.0 + 0.01 * repeat}}));
  }
  EXPECT_EQ(judge(race.contest(), {Axis::evaluations, 50.0}).standings.at(0).optimizer, "quick");
  EXPECT_EQ(judge(race.contest(), {Axis::evaluations, 80.0}).standings.at(0).optimizer, "thorough");
  EXPECT_EQ(judge(race.contest(), {Axis::seconds, 1.0}).standings.at(0).optimizer, "quick");
  EXPECT_EQ(judge(race.contest(), kWhole).standings.at(0).optimizer, "thorough");
  const Verdict start = judge(race.contest(), {Axis::evaluations, 4.0});
  EXPECT_FALSE(start.improved);
  EXPECT_EQ(start.to_take().size(), 2u);
  EXPECT_TRUE(judge(race.contest(), {Axis::seconds, 1e-4}).nobody);  // the start takes a millisecond
  EXPECT_TRUE(judge(race.contest(), {Axis::seconds, 1e-4}).to_take().empty());
}

TEST(Verdict, AFailedTrialHasNothing) {
  Race race;
  race.add_all("sure", {3.0, 3.0, 3.1});
  race.add_all("frail", {2.0, 2.1, 2.2});
  int failures = 0;
  for (TrialRecord& record : race.records)
    if (record.optimizer == "frail" && failures++ < 2) record.end = End::failed;
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(verdict.standings.at(0).optimizer, "sure");
  EXPECT_FALSE(standing(verdict, "frail").quality.median);
  EXPECT_EQ(standing(verdict, "frail").quality.lower, std::nullopt);  // halfway between 2.2 and never
}

// All that lived went one way, as a multi-start method's first fit does: two crashes of fifteen are two of fifteen, not
// two of three.
TEST(Verdict, AFewFailuresDontOutweighWhatIsTheSame) {
  Race race;
  race.add_all("frail", std::vector<double>(15, 2.0));
  race.add_all("sure", kHigh);
  for (const std::size_t i : {3u, 9u}) {
    race.records[i].end = End::crashed;
    race.records[i].start = {};
    race.records[i].trace.clear();
    race.records[i].best.reset();
  }
  Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(verdict.standings.at(0).optimizer, "frail");
  EXPECT_EQ(verdict.standings.at(0).observations, 15u);
  EXPECT_DOUBLE_EQ(*verdict.standings.at(0).quality.median, 2.0);
  EXPECT_DOUBLE_EQ(*verdict.standings.at(0).median_interval.upper, 2.0);  // the 12th of 15
  race.set_deterministic("frail");
  verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(verdict.standings.at(0).optimizer, "frail");
  EXPECT_EQ(verdict.standings.at(0).observations, 1u);
}

TEST(Verdict, WhereAllHaveFailedThereIsNothingToTake) {
  Race race;
  race.add_all("a", {3.0, 3.0});
  for (TrialRecord& record : race.records) record.end = End::crashed;
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_TRUE(verdict.nobody);
  EXPECT_TRUE(verdict.to_take().empty());
  EXPECT_EQ(verdict.standings.size(), 1u);
}

TEST(Verdict, OfNoTrialThereIsNoStanding) {
  Race race;
  race.optimizers = {{"a", "a"}};
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_TRUE(verdict.nobody);
  EXPECT_TRUE(verdict.standings.empty());
  EXPECT_EQ(verdict.next(), nullptr);
}

TEST(Verdict, OneOptimizerIsFirstAndNothingIsNext) {
  Race race;
  race.add_all("only", {3.0});
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(taken(verdict), Labels{"only"});
  EXPECT_EQ(verdict.next(), nullptr);
  EXPECT_FALSE(verdict.standings[0].median_interval.lower);
}

TEST(Verdict, TakesSecondsOfTheTrialsThatTablesTakeThemOf) {
  Race race;
  race.add_all("a", {2.0, 2.1, 9.0});
  race.add_all("b", {4.0, 4.1, 4.2});
  for (TrialRecord& record : race.records)
    record.conditions = Conditions{"", "", record.optimizer == "a" && record.repeat == 2 ? 1 : 2, 2, false, false};
  const Verdict by_time = judge(race.contest(), {Axis::seconds, 100.0});
  EXPECT_EQ(standing(by_time, "a").trials, 1u);  // the one that ran alone
  EXPECT_DOUBLE_EQ(*standing(by_time, "a").quality.median, 9.0);
  EXPECT_EQ(standing(by_time, "b").trials, 3u);
  EXPECT_EQ(standing(judge(race.contest(), {Axis::evaluations, 100.0}), "a").trials, 3u);
}

// Beside others twelve of fifteen crashed, and the timing lane ran the rest once more: they are its winners, not all.
TEST(Verdict, ALaneKeepsTheShareOfThoseThatFailed) {
  const auto under_time = [](std::size_t failures) {
    Race race;
    race.add_all("frail", {2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8, 2.9, 3.0, 3.1, 3.2, 3.3, 3.4});
    race.add_all("sure", kHigh);
    for (std::size_t i = 0; i < 15; ++i) {
      race.records[i].conditions = Conditions{"", "", i < 12 ? 2 : 1, 2, false, false};
      if (i < failures) race.records[i].end = End::crashed;
    }
    return judge(race.contest(), {Axis::seconds, 100.0});
  };
  EXPECT_EQ(taken(under_time(12)), Labels{"sure"});
  EXPECT_FALSE(standing(under_time(12), "frail").quality.median);
  EXPECT_EQ(standing(under_time(12), "frail").observations, 15u);
  // Five failed beside ten that didn't: beside the lane's three that is 1.5, rounded.
  EXPECT_EQ(under_time(5).standings.at(0).optimizer, "frail");
  EXPECT_EQ(standing(under_time(5), "frail").observations, 5u);
  EXPECT_EQ(standing(under_time(0), "frail").observations, 3u);
}

// Whole trials: those that the clock ended count by the lane's, and all failures would outweigh these.
TEST(Verdict, OfTrialsThatTheClockEndedTheShareOfFailuresIsKept) {
  Race race;
  race.add_all("a", {2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8, 2.9, 3.0, 3.1, 3.2, 3.3, 3.4});
  for (std::size_t i = 0; i < 15; ++i) {
    race.records[i].conditions = Conditions{"", "", i % 5 == 0 ? 1 : 2, 2, false, false};
    race.records[i].reason = "seconds spent";
    if (i % 5 == 1) race.records[i].end = End::failed;
  }
  const Verdict verdict = judge(race.contest(), kWhole);
  EXPECT_EQ(verdict.standings.at(0).observations, 4u);  // three alone; of three failures 3 · 3/12, rounded
  EXPECT_TRUE(verdict.standings.at(0).quality.median);
}

TEST(Verdict, DisturbedTimesDontCountAsLongAsThereAreOthers) {
  Race race;
  race.add_all("a", {2.0, 2.1, 9.0});
  race.add_all("b", {4.0, 4.1, 4.2});
  for (TrialRecord& record : race.records)
    if (record.repeat == 2 || record.optimizer == "b") record.seconds.cpu = 0.1 * record.seconds.total;
  const Verdict by_time = judge(race.contest(), {Axis::seconds, 100.0});
  const Standing &a = standing(by_time, "a"), &b = standing(by_time, "b");
  EXPECT_EQ(a.trials, 2u);
  EXPECT_EQ(a.disturbed, 1u);
  EXPECT_FALSE(a.only_disturbed);
  EXPECT_DOUBLE_EQ(*a.quality.median, 2.05);
  EXPECT_EQ(b.trials, 3u);
  EXPECT_TRUE(b.only_disturbed);
  // Evaluations are the same on a busy machine.
  EXPECT_EQ(standing(judge(race.contest(), {Axis::evaluations, 100.0}), "a").trials, 3u);
  EXPECT_EQ(standing(judge(race.contest(), kWhole), "a").trials, 3u);
  for (TrialRecord& record : race.records) record.reason = "seconds spent";
  EXPECT_EQ(standing(judge(race.contest(), kWhole), "a").trials, 2u);
}

TEST(Verdict, UsualLimitsStayBelowTheBudget) {
  const auto costs = [](const std::vector<Limit>& limits) {
    std::vector<double> all;
    for (const Limit& limit : limits) all.push_back(limit.cost.value_or(-1.0));
    return all;
  };
  EXPECT_EQ(costs(usual_limits({}, {})), (std::vector<double>{1e-3, 1e-2, 1e-1, -1.0, 100.0, 1000.0, -1.0}));
  EXPECT_EQ(costs(usual_limits(0.1, 1000.0)), (std::vector<double>{1e-3, 1e-2, -1.0, 100.0, -1.0}));
}

}  // namespace
}  // namespace nodal
