// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/minima.h>

#include <gtest/gtest.h>

#include <vector>

namespace nodal {
namespace {

TrialRecord ended(double quality, std::vector<double> x, std::optional<double> slope, double cost = 1.0) {
  TrialRecord record;
  record.end = End::finished;
  record.best = BestPoint{1, {cost, quality, std::nullopt}, std::move(x)};
  record.audit = AuditRecord{.stationarity = slope};
  return record;
}

Minima minima_of(const std::vector<TrialRecord>& records) {
  std::vector<const TrialRecord*> trials;
  for (const TrialRecord& record : records) trials.push_back(&record);
  return minima(trials);
}

TEST(Minima, AreToldApartByQuality) {
  const Minima found = minima_of({ended(0.75, {5.0, 0.0}, 1e-6), ended(0.73763, {1.0, 2.0}, 1e-6),
                                  ended(0.73764, {1.5, -2.0}, 1e-9), ended(0.80, {0.0, 0.0}, 1e-2)});
  ASSERT_EQ(found.found.size(), 2u);
  EXPECT_EQ(found.found[0].quality, 0.73763);
  EXPECT_EQ(found.found[0].trials.size(), 2u);
  EXPECT_EQ(found.found[0].width, 4.0);
  EXPECT_EQ(found.found[1].quality, 0.75);
  EXPECT_EQ(found.found[1].width, 0.0);
  EXPECT_EQ(found.on_the_way.size(), 1u);
  EXPECT_EQ(found.unknown, 0u);
}

TEST(Minima, HaveAllPerfectFitsInOne) {
  const Minima found = minima_of({ended(1e-15, {0.0}, std::nullopt, 1e-30), ended(3e-13, {1.0}, std::nullopt, 1e-26)});
  ASSERT_EQ(found.found.size(), 1u);
  EXPECT_EQ(found.found[0].width, 1.0);
}

TEST(Minima, KnowNothingOfTrialsWithoutASlopeOrAPoint) {
  TrialRecord lost, failed = ended(0.5, {1.0}, 1e-9), old = ended(0.5, {1.0}, 1e-9);
  lost.end = End::crashed;
  failed.end = End::failed;
  old.audit.reset();
  const Minima found = minima_of({ended(0.5, {1.0}, std::nullopt), lost, failed, old});
  EXPECT_TRUE(found.found.empty());
  EXPECT_EQ(found.unknown, 4u);
  EXPECT_TRUE(minima({}).found.empty());
}

}  // namespace
}  // namespace nodal
