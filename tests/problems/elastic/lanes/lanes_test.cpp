// SPDX-License-Identifier: GPL-3.0-or-later
// The lane factor against CHOLMOD: every instruction set that runs here, 1, 2, 4 and 8 groups, one and several loads.
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/random.h>

#include "full_evaluation.h"
#include "lanes/lane_model.h"
#include "lanes/lane_system.h"
#include "../plate.h"

namespace nodal::elastic {
namespace {

struct Setup {
  std::size_t groups;
  std::string supports;
  std::string instructions;
};

// A plate whose load set has as many support groups as wanted: those of "edge", repeated.
Scene scene_with(const Setup& setup) {
  Scene scene = make_plate({.supports = setup.supports, .topology = "alternating", .counts = "[6, 5]"})->scene();
  const LoadSet once = scene.loads;
  scene.loads.groups.resize(1);
  std::erase_if(scene.loads.loads, [](const LoadCase& load) { return load.group != 0; });
  for (std::size_t g = 1; g < setup.groups; ++g) {
    LoadCase load = once.loads[g % once.loads.size()];
    scene.loads.groups.push_back(once.groups[load.group]);
    load.group = g;
    scene.loads.loads.push_back(load);
  }
  scene.moves.instructions = setup.instructions;
  return scene;
}

class Lanes : public testing::TestWithParam<Setup> {
 protected:
  Lanes() : model_(scene_with(GetParam())), full_(model_), systems_(make_systems(model_, model_.lanes())) {
    RandomStream random(5);
    for (std::size_t e = 0; e < model_.scene.net.springs.size(); ++e)
      stiffness_.push_back(std::exp(random.uniform(-3.0, 3.0)));
  }

  // Placed numbers of a group from its lane.
  std::vector<double> of_group(std::size_t g, const double* pairs) const {
    const LaneStructure& structure = systems_[0].structure();
    std::vector<double> placed;
    for (std::size_t place = 0; place < model_.groups[g]->freedoms(); ++place) {
      const std::size_t freedom = model_.groups[g]->freedom_at(place);
      placed.push_back(pairs[structure.at(freedom, g)]);
    }
    return placed;
  }

  ElasticModel model_;
  FullEvaluation full_;
  std::vector<LaneSystem> systems_;
  std::vector<double> stiffness_;
};

TEST_P(Lanes, SolveForTheLoadsLikeCholmod) {
  ASSERT_EQ(systems_.size(), 1u);
  LaneSystem& system = systems_[0];
  ASSERT_EQ(full_.solve(stiffness_), Status::ok);
  ASSERT_TRUE(system.factorize(stiffness_).fine);
  AlignedArray u(system.structure().slots() * system.structure().vector_size());
  system.kernels().solve_loads(system.view(), u.data());
  for (const LaneStructure::Slot& slot : system.structure().loads()) {
    const std::vector<double> ours = of_group(slot.group, u.data() + slot.slot * system.structure().vector_size());
    const std::span<const double> theirs = full_.group(slot.group).displacement(slot.slot);
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-11 * (1.0 + std::abs(theirs[i])));
  }
  // Contrast 400, 30 nodes: a plain solve keeps about 12 digits.
  EXPECT_NEAR(system.kernels().squared_error(system.view(), u.data()), full_.squared(), 1e-11 * full_.squared());
  EXPECT_TRUE(system.agrees_with(full_, model_.reference_norm));
}

TEST_P(Lanes, FollowAChangedSpringLikeAFreshFactor) {
  LaneSystem& system = systems_[0];
  ASSERT_TRUE(system.factorize(stiffness_).fine);
  std::vector<LaneSystem> others = make_systems(model_, model_.lanes());
  LaneSystem& fresh = others[0];
  RandomStream random(6);
  const LaneView& view = system.view();
  AlignedArray z(system.structure().vector_size());
  for (int step = 0; step < 200; ++step) {
    const auto e = static_cast<std::uint32_t>(random.index(stiffness_.size()));
    const double delta = stiffness_[e] * (std::exp(random.uniform(-1.0, 1.0)) - 1.0);
    ASSERT_TRUE(system.kernels().change_and_solve(view, e, delta));
    stiffness_[e] += delta;
    ASSERT_TRUE(fresh.factorize(stiffness_).fine);
    fresh.kernels().solve_spring(fresh.view(), e, z.data());
    for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(view.z[i], delta * z[i], 1e-9 * std::abs(delta));
    for (std::size_t i = 0; i < z.size(); ++i) z[i] *= delta * view.weight[i];
    fresh.kernels().solve(fresh.view(), z.data());
    for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(view.y[i], z[i], 1e-7 * std::abs(delta));
  }
}

TEST_P(Lanes, NoticeASystemThatIsNotPositiveDefinite) {
  LaneSystem& system = systems_[0];
  stiffness_[3] = -50.0;
  EXPECT_FALSE(system.factorize(stiffness_).fine);
  stiffness_[3] = 1.0;
  ASSERT_TRUE(system.factorize(stiffness_).fine);
  EXPECT_FALSE(system.kernels().change_factor(system.view(), 3, -60.0));
}

std::vector<Setup> setups() {
  std::vector<Setup> all;
  for (const LaneInstructions& set : lane_instructions()) {
    if (!set.usable) continue;
    for (const std::size_t groups : {1, 2, 3, 4, 7}) all.push_back({groups, "edge", set.name});
    all.push_back({1, "minimal", set.name});  // three loads of one group
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Everything, Lanes, testing::ValuesIn(setups()), [](const auto& p) {
  return p.param.instructions + "_" + p.param.supports + "_" + std::to_string(p.param.groups);
});

TEST(LaneKernels, AreRefusedByNameAndNumber) {
  EXPECT_THROW((void)lane_kernels("auto", 2, 3), std::invalid_argument);
  EXPECT_THROW((void)lane_kernels("mmx", 2, 4), std::invalid_argument);
  EXPECT_THROW((void)lane_kernels("auto", 4, 4), std::invalid_argument);
  EXPECT_TRUE(lane_instructions().front().usable);
}

}  // namespace
}  // namespace nodal::elastic
