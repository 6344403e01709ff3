// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/scrutiny.h>

#include "analysis_trials.h"

namespace nodal {
namespace {

using Way = std::vector<std::pair<std::int64_t, double>>;
const Way kFive = {{2, 9.0}, {4, 7.0}, {5, 6.0}, {8, 4.0}, {9, 3.0}};

TrialRecord claiming(int repeat, std::optional<double> cost, std::optional<std::int64_t> evaluations = {},
                     std::optional<bool> x_equals_best = {}) {
  TrialRecord record = trial("a", repeat, kFive);  // whose best point costs 1 after 100 evaluations
  record.claimed = ClaimRecord{cost, x_equals_best, evaluations, "done"};
  return record;
}

ClaimsSeen seen(std::vector<TrialRecord> records) { return claims_seen(pointers(records)); }

TEST(Claims, ThatAgreeAreNothingToSay) {
  const ClaimsSeen found = seen({claiming(0, 1.0, 100, true), claiming(1, 1.0 + 1e-12, 100), claiming(2, {})});
  EXPECT_EQ(found.claiming, 3u);
  EXPECT_TRUE(found.agrees());
  EXPECT_TRUE(seen({trial("a", 0, kFive)}).agrees());
}

TEST(Claims, BetterThanWhatWasSeenAreLies) {
  const ClaimsSeen found = seen({claiming(0, 0.99), claiming(1, 0.5), claiming(2, 1.0)});
  EXPECT_FALSE(found.agrees());
  EXPECT_EQ(found.better.trials, 2u);
  EXPECT_EQ(found.better.repeat, 1);
  EXPECT_EQ(found.better.claimed, 0.5);
  EXPECT_EQ(found.better.seen, 1.0);
}

TEST(Claims, WorseThanWhatWasSeenLoseIt) {
  const ClaimsSeen found = seen({claiming(0, 1.25, {}, false)});
  EXPECT_EQ(found.worse.trials, 1u);
  EXPECT_EQ(found.other_points, 1u);
  // Another point of the same cost loses nothing.
  EXPECT_EQ(seen({claiming(0, 1.0, {}, false)}).other_points, 0u);
}

TEST(Claims, OfTheRacesBestSayNothingOfWhatAValidatedStopChose) {
  TrialRecord honest = claiming(0, 0.5, 100, true);
  honest.unseen = UnseenRecord{{"x", "y"}, {}, 0, {}};
  EXPECT_EQ(seen({honest}).better.trials, 1u);
  honest.unseen->stop = ValidatedStop{5, 9, 3.0};
  EXPECT_TRUE(seen({honest}).agrees());
  honest.claimed->cost = 1.25;
  EXPECT_TRUE(seen({honest}).agrees());
  honest.claimed->evaluations = 90;
  EXPECT_EQ(seen({honest}).evaluations.trials, 1u);
}

TEST(Claims, CountEvaluationsAsTheMeterDoes) {
  std::vector<TrialRecord> records = {claiming(0, 1.0, 100), claiming(1, 1.0, 90), claiming(2, 1.0, 103)};
  ClaimsSeen found = seen(records);
  EXPECT_EQ(found.evaluations.trials, 1u);  // what the meter has ended counts on
  EXPECT_EQ(found.evaluations.claimed, 90);
  EXPECT_EQ(found.evaluations.seen, 100);
  records[2].end = End::finished;
  found = seen(records);
  EXPECT_EQ(found.evaluations.trials, 2u);
  EXPECT_EQ(found.evaluations.repeat, 1);  // the farthest off
}

std::vector<Alias> alike(std::vector<TrialRecord> records) { return aliases(pointers(records)); }

TEST(Aliases, AreEntriesThatDoTheSameInEveryRepeat) {
  const std::vector<Alias> found = alike(
      {trial("a", 0, kFive), trial("b", 0, kFive), trial("a", 1, kFive), trial("b", 1, kFive), trial("c", 0, {})});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, "a");
  EXPECT_EQ(found[0].second, "b");
  EXPECT_EQ(found[0].repeats, 2u);
}

TEST(Aliases, OneRepeatThatDiffersTellsThemApart) {
  Way other = kFive;
  other[2].second = std::nextafter(other[2].second, 0.0);
  EXPECT_TRUE(alike({trial("a", 0, kFive), trial("b", 0, kFive), trial("a", 1, kFive), trial("b", 1, other)}).empty());
  other = kFive;
  ++other[1].first;
  EXPECT_TRUE(alike({trial("a", 0, kFive), trial("b", 0, other)}).empty());
}

// The clock stops one earlier than the other; what ended by itself, another would have gone on from.
TEST(Aliases, MayHaveBeenStoppedByTheClock) {
  Way longer = kFive;
  longer.push_back({150, 1.0});
  EXPECT_EQ(alike({trial("a", 0, kFive), trial("b", 0, longer, 200)}).size(), 1u);
  EXPECT_EQ(alike({trial("a", 0, longer, 200), trial("b", 0, kFive)}).size(), 1u);
  TrialRecord finished = trial("a", 0, kFive);
  finished.end = End::finished;
  EXPECT_TRUE(alike({finished, trial("b", 0, longer, 200)}).empty());
}

TEST(Aliases, WhoFindsNextToNothingIsNotTold) {
  EXPECT_TRUE(alike({trial("a", 0, {}), trial("b", 0, {})}).empty());
  const Way four(kFive.begin(), kFive.begin() + 4);
  EXPECT_TRUE(alike({trial("a", 0, four), trial("b", 0, four)}).empty());
  EXPECT_TRUE(alike({trial("a", 0, kFive), trial("b", 1, kFive)}).empty());  // no repeat that both have
}

TEST(FirstToRest, IsTimePerEvaluation) {
  std::vector<TrialRecord> records = {trial("a", 0, kFive), trial("a", 1, kFive), trial("a", 2, kFive, 50)};
  records[0].seconds.total *= 1.5;
  EXPECT_DOUBLE_EQ(*first_to_rest(pointers(records)), 1.5);
  records.pop_back();
  EXPECT_FALSE(first_to_rest(pointers(records)));
}

TEST(FirstToRest, IsNotToldOfMoments) {
  std::vector<TrialRecord> records = {trial("a", 0, kFive), trial("a", 1, kFive), trial("a", 2, kFive)};
  for (TrialRecord& record : records) record.seconds.total = 0.5 * kShortestToldSeconds;
  EXPECT_FALSE(first_to_rest(pointers(records)));
}

}  // namespace
}  // namespace nodal
