// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/statistics/two_samples.h>

#include "never.h"

namespace nodal::statistics {
namespace {

TEST(TwoSamples, EffectSizeCountsPairs) {
  EXPECT_EQ(vargha_delaney(std::vector{1.0, 3.0}, std::vector{2.0, 3.0}), (0.0 + 0.0 + 1.0 + 0.5) / 4.0);
  EXPECT_EQ(vargha_delaney(std::vector{2.0, 2.0}, std::vector{1.0}), 1.0);
  EXPECT_FALSE(vargha_delaney({}, std::vector{1.0}));
}

TEST(TwoSamples, EqualOnesDoNotDiffer) {
  const std::vector<double> same(6, 2.5), never(6, kNever);
  EXPECT_EQ(mann_whitney(same, same)->p, 1.0);
  EXPECT_EQ(mann_whitney(never, never)->p, 1.0);
  EXPECT_EQ(wilcoxon(same, same)->p, 1.0);
  EXPECT_EQ(wilcoxon(never, never)->p, 1.0);
  EXPECT_FALSE(mann_whitney(same, {}));
  EXPECT_FALSE(wilcoxon({}, {}));
}

TEST(TwoSamples, OneNeverAndOneAlwaysDiffer) {
  const std::vector<double> always = {1, 2, 3, 4, 5, 6, 7, 8}, never(8, kNever);
  EXPECT_LT(mann_whitney(always, never)->p, 1e-3);
  EXPECT_EQ(vargha_delaney(never, always), 1.0);
  EXPECT_LT(wilcoxon(always, never)->p, 0.01);  // by the approximation: infinite differences are tied
}

// All 2³ signs of ranks 1, 2, 3: W ≤ 1 has the subsets {} and {1}, so p = 2 · 2/8.
TEST(TwoSamples, ExactSignedRanksByHand) {
  const RankTest test = *wilcoxon(std::vector{2.0, 1.0, 1.0}, std::vector{1.0, 3.0, 5.0});
  EXPECT_EQ(test.statistic, 1.0);
  EXPECT_EQ(test.p, 0.5);
}

TEST(TwoSamples, PairsWithoutADifferenceDoNotCount) {
  const RankTest with = *wilcoxon(std::vector{2.0, 1.0, 1.0, 7.0}, std::vector{1.0, 3.0, 5.0, 7.0});
  EXPECT_EQ(with.p, 0.5);
  EXPECT_THROW((void)wilcoxon(std::vector{1.0}, std::vector{1.0, 2.0}), std::invalid_argument);
}

TEST(TwoSamples, HolmNeverReverses) {
  EXPECT_EQ(holm(std::vector{0.01, 0.04, 0.03}), (std::vector{0.03, 0.06, 0.06}));
  EXPECT_EQ(holm(std::vector{0.5, 0.9}), (std::vector{1.0, 1.0}));
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace nodal::statistics
