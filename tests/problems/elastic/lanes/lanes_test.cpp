// SPDX-License-Identifier: GPL-3.0-or-later
// The lane factor against CHOLMOD: every instruction set that runs here, 1, 2, 4 and 8 groups, one and several loads.
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/random.h>

#include "../plate.h"
#include "displacements/full_evaluation.h"
#include "displacements/lane_model.h"
#include "displacements/lane_system.h"

namespace nodal::elastic {
namespace {

struct Setup {
  std::size_t groups;
  std::string supports;
  std::string instructions;
  bool moved = false;
};

// Every other held freedom stands away from zero, and a second load in the first group only.
void move_supports(LoadSet& loads) {
  double value = 0.5;
  for (SupportGroup& group : loads.groups)
    for (std::size_t i = 0; i < group.supports.size(); i += 2) group.supports[i].value = value = -0.8 * value;
  LoadCase more = loads.loads.front();
  for (double& force : more.forces) force *= -0.5;
  loads.loads.push_back(std::move(more));
}

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
  if (setup.moved) move_supports(scene.loads);
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
  system.kernels().solve_loads(system.view(), stiffness_.data(), u.data());
  for (const LaneStructure::Slot& slot : system.structure().loads()) {
    const std::vector<double> ours = of_group(slot.group, u.data() + slot.slot * system.structure().vector_size());
    const std::span<const double> theirs = full_.group(slot.group).displacement(slot.slot);
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-11 * (1.0 + std::abs(theirs[i])));
  }
  // Contrast 400, 30 nodes: a plain solve keeps about 12 digits.
  EXPECT_NEAR(system.kernels().squared_error(system.view(), u.data()), full_.squared(), 1e-11 * full_.squared());
  EXPECT_TRUE(system.agrees_with(full_, stiffness_, model_.reference_norm));
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
    for (const std::size_t groups : {1, 3}) all.push_back({groups, "edge", set.name, true});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Everything, Lanes, testing::ValuesIn(setups()), [](const auto& p) {
  return p.param.instructions + "_" + p.param.supports + "_" + std::to_string(p.param.groups) +
         (p.param.moved ? "_moved" : "");
});

// Every form's prices, values and derivatives where supports move, against CHOLMOD's.
class MovedSupports : public testing::TestWithParam<std::string> {
 protected:
  static std::shared_ptr<const ElasticProblem> problem(const std::string& solver) {
    Scene scene = scene_with({4, "edge", "auto", true});
    scene.solver = solver;
    scene.moves.form = GetParam();
    return std::make_shared<const ElasticProblem>(std::move(scene));
  }
};

TEST_P(MovedSupports, ArePricedLikeFullEvaluations) {
  const auto by_lanes = problem("auto"), by_cholmod = problem("simplicial");
  const auto walking = by_lanes->make_evaluator(), lanes = by_lanes->make_evaluator(),
             cholmod = by_cholmod->make_evaluator();
  const Space& space = by_lanes->space();
  std::vector<double> x(space.start().begin(), space.start().end());
  Moves& moves = *walking->moves();
  ASSERT_TRUE(moves.reset(x).ok());
  RandomStream random(3);
  for (int step = 0; step < 200; ++step) {
    const std::size_t i = random.index(x.size());
    const double value = x[i] + random.uniform(-1.0, 1.0);
    const Evaluation priced = moves.propose(i, value);
    ASSERT_TRUE(priced.ok());
    x[i] = value;
    const double exact = cholmod->audit(x).cost;
    EXPECT_NEAR(priced.cost, exact, 1e-9 * exact) << step;  // what a walk promises
    EXPECT_NEAR(lanes->value(x).cost, exact, 1e-10 * exact) << step;
    ASSERT_EQ(moves.accept(), Status::ok);
  }
  EXPECT_EQ(moves.report().choices.front().form, GetParam());
  EXPECT_EQ(moves.report().choices.size(), 1u);
  std::vector<double> ours(x.size()), theirs(x.size());
  ASSERT_TRUE(lanes->value_and_gradient(x, ours).ok());
  ASSERT_TRUE(cholmod->value_and_gradient(x, theirs).ok());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-9 * std::abs(theirs[i]) + 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Forms, MovedSupports, testing::Values("eager", "lazy", "refactor", "updown", "full"),
                         [](const auto& p) { return p.param; });

TEST(LaneKernels, AreRefusedByNameAndNumber) {
  EXPECT_THROW((void)lane_kernels("auto", 2, 3), std::invalid_argument);
  EXPECT_THROW((void)lane_kernels("mmx", 2, 4), std::invalid_argument);
  EXPECT_THROW((void)lane_kernels("auto", 4, 4), std::invalid_argument);
  EXPECT_TRUE(lane_instructions().front().usable);
}

}  // namespace
}  // namespace nodal::elastic
