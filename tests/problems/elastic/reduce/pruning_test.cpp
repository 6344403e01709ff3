// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/pruning.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "../plate.h"
#include "rigidity/rigidity.h"

namespace nodal::elastic {
namespace {

constexpr double kLower = 1e-4;

// The plate with one diagonal of each cell at the lower bound: what stays is the "single" plate, which is rigid.
TEST(Pruning, TakesSoftSpringsAndSaysWhatIsLost) {
  const auto plate = make_plate();
  std::vector<double> k(plate->net().springs.size(), 1.0);
  std::size_t falling = 0;
  for (std::size_t e = 0; e < k.size(); ++e)
    if (plate->net().springs[e].direction[0] * plate->net().springs[e].direction[1] < 0.0) k[e] = kLower, ++falling;
  const Pruned pruned = prune(*plate, k);
  EXPECT_EQ(falling, 16u);
  EXPECT_EQ(pruned.removed.size(), 16u);
  EXPECT_TRUE(pruned.kept_soft.empty());
  ASSERT_EQ(pruned.problem->net().springs.size(), 56u);
  EXPECT_EQ(pruned.problem->account().detail_of("springs"), "crossed, pruned, 56 springs");
  EXPECT_NE(pruned.problem->account().detail_of(kRigidityStage), "");  // of the plate's own grid it isn't asked
  EXPECT_EQ(pruned.quality, plate->solve(k).quality);

  // The same system as the plate that never had them.
  const auto single = make_plate({.topology = "single"});
  const double expected = single->solve(std::vector<double>(56, 1.0)).quality;
  EXPECT_NEAR(pruned.pruned_quality, expected, 1e-12 * expected);
  EXPECT_EQ(pruned.problem->solve(pruned.stiffness).quality, pruned.pruned_quality);
  EXPECT_NE(describe(pruned).find("16 of 72 springs at the lower bound left out; relative error"), std::string::npos);
}

// Both diagonals of every cell at the bound: cells would shear. As many stay as rigidity needs, and no more.
TEST(Pruning, KeepsWhatTheNetNeedsToBeRigid) {
  const auto plate = make_plate({.supports = "minimal"});
  std::vector<double> k(plate->net().springs.size(), 1.0);
  std::size_t soft = 0;
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Vector& d = plate->net().springs[e].direction;
    if (d[0] != 0.0 && d[1] != 0.0) k[e] = kLower * (1.0 + 1e-6 * static_cast<double>(e)), ++soft;
  }
  const Pruned pruned = prune(*plate, k);
  // 40 springs along the axes; 2 · 25 − 3 = 47 make a rigid body.
  EXPECT_EQ(soft, 32u);
  EXPECT_EQ(pruned.kept_soft.size(), 7u);
  EXPECT_EQ(pruned.removed.size(), 25u);
  EXPECT_TRUE(free_rigidity(structure_of(pruned.problem->net())).is_rigid());
  for (std::size_t leave = 0; leave < pruned.kept_soft.size(); ++leave) {
    std::vector<Spring> without = pruned.problem->net().springs;
    const Spring& one = plate->net().springs[pruned.kept_soft[leave]];
    std::erase_if(without, [&](const Spring& s) { return s.first == one.first && s.second == one.second; });
    EXPECT_FALSE(free_rigidity({2, plate->net().nodes, without}).is_rigid());
  }
}

// A good net whose diagonals happen to be at the bound: not all may go, and how many depends on what may be lost.
TEST(Pruning, StopsWhereTheErrorWouldGrowTooMuch) {
  const auto plate = make_plate({.bounds = "[0.36, 10.0]"});
  std::vector<double> k(plate->net().springs.size(), 0.75);
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Vector& d = plate->net().springs[e].direction;
    if (d[0] != 0.0 && d[1] != 0.0) k[e] = 0.36;
  }
  std::size_t fewer = 0;
  for (const double loss : {0.0, 0.05, 1.0}) {
    const Pruned pruned = prune(*plate, k, loss);
    EXPECT_LE(pruned.pruned_quality, (1.0 + loss) * pruned.quality);
    EXPECT_GE(pruned.removed.size(), fewer) << loss;
    EXPECT_GT(pruned.kept_for_error, 0u) << loss;
    EXPECT_NE(describe(pruned).find("kept because the error would grow too much"), std::string::npos);
    fewer = pruned.removed.size();
  }
  EXPECT_GT(fewer, 0u);
  EXPECT_GT(prune(*plate, k).removed.size(), fewer);
}

// Springs that were tied stay tied.
TEST(Pruning, KeepsTies) {
  const auto plate = make_plate({.parameters = "by-direction"});
  std::vector<double> k(plate->net().springs.size(), 1.0);
  for (std::size_t e = 0; e < k.size(); ++e)
    if (plate->net().springs[e].direction[0] * plate->net().springs[e].direction[1] < 0.0) k[e] = kLower;
  const Pruned pruned = prune(*plate, k);
  EXPECT_EQ(pruned.removed.size(), 16u);
  EXPECT_EQ(pruned.problem->parameters().size(), 3u);
}

TEST(Pruning, OfAFitThatHoldsNoSoftSpringChangesNothing) {
  const auto plate = make_plate();
  const std::vector<double> k(72, 0.5);
  const Pruned pruned = prune(*plate, k);
  EXPECT_TRUE(pruned.removed.empty());
  EXPECT_EQ(pruned.stiffness, k);
  EXPECT_NEAR(pruned.pruned_quality, pruned.quality, 1e-14 * pruned.quality);
}

TEST(Pruning, RefusesWrongSizes) {
  const std::vector<double> k(71, 0.5);
  EXPECT_THROW((void)prune(*make_plate(), k), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::elastic
