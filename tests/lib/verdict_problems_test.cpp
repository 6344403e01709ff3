// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verdict.h>

#include <gtest/gtest.h>

#include <cmath>

#include <nodal/statistics/two_samples.h>

#include "verdict_trials.h"

namespace nodal {
namespace {

using Labels = std::vector<std::string>;

std::vector<double> shifted(std::vector<double> values, double by) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += by + 0.001 * static_cast<double>(i);
  return values;
}

const std::vector<double> kBase = {2.0, 2.5, 3.0, 3.5, 4.0, 4.5};

// a is first on two of three problems, by pairs of all of them.
TEST(VerdictOfProblems, TakesTheLeastMeanRank) {
  std::vector<Race> races(3);
  for (std::size_t p = 0; p < 3; ++p) {
    races[p].add_all("c", shifted(kBase, 2.0), true);
    races[p].add_all("a", shifted(kBase, p == 2 ? 1.0 : 0.0), true);
    races[p].add_all("b", shifted(kBase, p == 2 ? 0.0 : 1.0), true);
  }
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1"), races[2].contest("p2")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(verdict.problems, (Labels{"p0", "p1", "p2"}));
  ASSERT_EQ(verdict.standings.size(), 3u);
  EXPECT_EQ(verdict.standings[0].optimizer, "a");
  EXPECT_DOUBLE_EQ(verdict.standings[0].rank, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(standing(verdict, "b").rank, 5.0 / 3.0);
  EXPECT_DOUBLE_EQ(standing(verdict, "c").rank, 3.0);
  EXPECT_EQ(verdict.standings[0].best_on, 2u);
  ASSERT_EQ(verdict.by_problem.size(), 3u);
  EXPECT_EQ(verdict.by_problem[2].standings[0].optimizer, "b");
  EXPECT_EQ(standing(verdict, "b").best_on, 1u);
  EXPECT_EQ(standing(verdict, "c").best_on, 0u);
  // χ² = 12·3/(3·4) [(16 + 25 + 81)/9 − 3·16/4] = 3 (13.556 − 12) = 4.667, p = exp(−χ²/2) with two degrees.
  EXPECT_NEAR(*verdict.friedman_p, std::exp(-0.5 * 14.0 / 3.0), 1e-12);
  EXPECT_EQ(standing(verdict, "c").test, PairTest::wilcoxon);
  EXPECT_EQ(standing(verdict, "c").pairs, 18u);
  EXPECT_EQ(standing(verdict, "c").relation, Relation::told);
  EXPECT_EQ(standing(verdict, "b").relation, Relation::untold);  // better on one of three
}

// Starts aren't shared: what single problems say is counted.
TEST(VerdictOfProblems, WithoutSharedStartsProblemsAreCounted) {
  const std::vector<double> low = {2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7};
  std::vector<Race> races(2);
  for (Race& race : races) {
    race.add_all("a", low);
    race.add_all("b", shifted(low, 3.0));
  }
  races[0].add_all("one", {9.0});
  races[1].add_all("one", {9.0});
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(taken(verdict), Labels{"a"});
  EXPECT_EQ(standing(verdict, "b").relation, Relation::told);
  EXPECT_FALSE(standing(verdict, "b").p);
  EXPECT_DOUBLE_EQ(*standing(verdict, "b").effect, 1.0);
  EXPECT_EQ(standing(verdict, "one").relation, Relation::untested);
  // Two tests, of equal p: Holm makes twice of it.
  EXPECT_EQ(verdict.tests, 2u);
  ASSERT_EQ(standing(verdict, "b").told_on.size(), 2u);
  EXPECT_EQ(standing(verdict, "b").told_on[1].problem, "p1");
  EXPECT_DOUBLE_EQ(standing(verdict, "b").told_on[1].p, 2.0 * statistics::mann_whitney(shifted(low, 3.0), low)->p);
  EXPECT_TRUE(standing(verdict, "b").told_on[1].worse);
}

// Four against four, all apart: p = 2(1 − Φ(7.5/√12)) = 0.0304, which is told of one problem, but not of one of two.
TEST(VerdictOfProblems, WithoutSharedStartsTestsAreAdjustedOverProblems) {
  std::vector<Race> races(2);
  for (Race& race : races) race.add_all("a", {2.0, 2.1, 2.2, 2.3});
  races[0].add_all("b", {3.0, 3.1, 3.2, 3.3});
  races[1].add_all("b", {2.0, 2.1, 2.2, 2.4});
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(standing(verdict.by_problem[0], "b").relation, Relation::told);
  EXPECT_EQ(standing(verdict, "b").relation, Relation::untold);
  EXPECT_EQ(standing(verdict, "b").tested_on, 2u);
  EXPECT_TRUE(standing(verdict, "b").told_on.empty());
}

TEST(VerdictOfProblems, WithoutSharedStartsOneAgainstTheRanksIsContrary) {
  const std::vector<double> low = {2.0, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7};
  std::vector<Race> races(3);
  for (std::size_t p = 0; p < 3; ++p) {
    races[p].add_all("a", p == 2 ? shifted(low, 3.0) : low);
    races[p].add_all("b", p == 2 ? low : shifted(low, 0.001));
  }
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1"), races[2].contest("p2")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(taken(verdict), (Labels{"a", "b"}));
  EXPECT_EQ(standing(verdict, "b").relation, Relation::contrary);
  ASSERT_EQ(standing(verdict, "b").told_on.size(), 1u);
  EXPECT_EQ(standing(verdict, "b").told_on[0].problem, "p2");
  EXPECT_FALSE(standing(verdict, "b").told_on[0].worse);
}

TEST(VerdictOfProblems, LeavesOutWhoHasNotTriedAll) {
  std::vector<Race> races(2);
  races[0].add_all("a", kBase, true);
  races[0].add_all("b", kBase, true);
  races[1].add_all("a", kBase, true);
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(verdict.standings.size(), 1u);
  EXPECT_EQ(verdict.partial, Labels{"b"});
  EXPECT_FALSE(verdict.friedman_p);
}

// x is the best on the one problem that it tried: there a is the least of those that tried both.
TEST(VerdictOfProblems, CountsLeastAndTiedAmongWhoHasTriedAll) {
  std::vector<Race> races(2);
  for (Race& race : races) {
    race.add_all("a", shifted(kBase, 1.0), true);
    race.add_all("b", shifted(kBase, 2.0), true);
  }
  races[0].add_all("x", kBase, true);
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(verdict.by_problem[0].standings[0].optimizer, "x");
  EXPECT_DOUBLE_EQ(standing(verdict, "a").rank, 1.0);
  EXPECT_EQ(standing(verdict, "a").best_on, 2u);
  EXPECT_EQ(standing(verdict, "a").tied_on, 2u);
}

TEST(VerdictOfProblems, OfOneIsThatOne) {
  Race race;
  race.add_all("a", kBase, true);
  const std::vector<Contest> contests = {race.contest("p0"), Race{}.contest("empty")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(verdict.problems, Labels{"p0"});
  EXPECT_TRUE(verdict.standings.at(0).quality.median);
  EXPECT_TRUE(judge(std::vector<Contest>{}, kWhole).nobody);
}

TEST(VerdictOfProblems, EqualOnAllIsEqual) {
  std::vector<Race> races(2);
  for (Race& race : races) {
    race.add_all("late", {2.0, 2.0, 2.0}, true, 90);
    race.add_all("soon", {2.0, 2.0, 2.0}, true, 10);
  }
  const std::vector<Contest> contests = {races[0].contest("p0"), races[1].contest("p1")};
  const Verdict verdict = judge(contests, kWhole);
  EXPECT_EQ(taken(verdict), (Labels{"soon", "late"}));
  EXPECT_EQ(verdict.standings[1].relation, Relation::equal);
  EXPECT_DOUBLE_EQ(verdict.standings[0].rank, 1.5);
}

}  // namespace
}  // namespace nodal
