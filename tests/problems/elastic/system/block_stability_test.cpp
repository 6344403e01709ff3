// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria in space that are hard to solve, by lanes and by CHOLMOD, against 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <nodal/elastic/extended_equilibrium.h>

#include "../block.h"

namespace nodal::elastic {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon(),
                 kLongRounding = std::numeric_limits<long double>::epsilon();

using Stiffness = std::function<double(const Scene&, const Spring&, RandomStream&)>;

struct HardCase {
  std::string name;
  BlockOptions block;
  Stiffness stiffness;
  double softest = 1.0;  // how much softer than a spring the net is along some motion
};

bool at_node(const Spring& s, std::size_t node) { return s.first == node || s.second == node; }
int axes_of(const Spring& s) {
  int axes = 0;
  for (const double d : s.direction) axes += d != 0.0;
  return axes;
}
Stiffness decades(double count) {
  return [count](const Scene&, const Spring&, RandomStream& random) {
    return std::pow(10.0, random.uniform(-count, count));
  };
}
// One inner node's springs so much stiffer or softer than the others.
Stiffness inclusion(double factor) {
  return [factor](const Scene&, const Spring& s, RandomStream& random) {
    return random.uniform(0.5, 2.0) * (at_node(s, 13) ? factor : 1.0);
  };
}

std::vector<HardCase> cases() {
  std::vector<HardCase> all;
  for (const char* supports : {"face", "minimal"}) {
    const auto add = [&](const std::string& name, BlockOptions block, Stiffness stiffness, double softest = 1.0) {
      block.supports = supports;
      block.bounds = "[1e-14, 1e14]";
      all.push_back({name + '_' + supports, std::move(block), std::move(stiffness), softest});
    };
    add("contrast_1e2", {}, decades(1.0));
    add("contrast_1e6", {}, decades(3.0));
    add("contrast_1e12", {.topology = "faces"}, decades(6.0));
    add("stiff_inclusion", {}, inclusion(1e6));
    add("soft_inclusion", {}, inclusion(1e-6));
    add("half_soft", {}, [](const Scene& scene, const Spring& s, RandomStream& random) {
      return random.uniform(0.5, 2.0) * (scene.net.nodes[s.first][0] + scene.net.nodes[s.second][0] > 2.0 ? 1e-6 : 1.0);
    });
    // Without diagonals a block shears; these are a millionth as stiff as the edges.
    const Stiffness soft_diagonals = [](const Scene&, const Spring& s, RandomStream& random) {
      return random.uniform(0.5, 2.0) * (axes_of(s) > 1 ? 1e-6 : 1.0);
    };
    add("near_mechanism", {.topology = "single"}, soft_diagonals, 1e6);
    add("slender", {.size = "[1, 1, 59]", .counts = "[2, 2, 60]"}, decades(0.5));
    add("flat_cells", {.size = "[2, 2, 0.002]", .counts = "[3, 3, 3]"}, decades(0.5), 1e6);  // (cell/height)²
  }
  return all;
}

class BlockStability : public testing::TestWithParam<HardCase> {
 protected:
  std::shared_ptr<const ElasticProblem> problem(const std::string& solver) const {
    BlockOptions options = GetParam().block;
    options.solver = solver;
    return make_block(options);
  }
};

TEST_P(BlockStability, AgreesWithFiftyDigits) {
  const auto by_lanes = problem("lanes"), by_cholmod = problem("simplicial");
  const Scene& scene = by_lanes->scene();
  RandomStream random(12);
  std::vector<double> x(by_lanes->space().size()), k;
  for (const Spring& s : scene.net.springs) k.push_back(GetParam().stiffness(scene, s, random));
  by_lanes->parameters().coordinates(k, x);
  k = by_lanes->stiffness(x);
  const auto exact = solve_extended(scene, k);
  ASSERT_TRUE(exact.has_value());

  // Refined: as far as doubles go, and residuals in the 64 bits of a long double where a motion is softer. The bound
  // that health states holds as it stands: a rounding per residual, and what the last correction says.
  const State state = by_cholmod->solve(k);
  ASSERT_EQ(state.status, Status::ok) << state.message;
  EXPECT_LE(displacement_error(state, *exact), 4.0 * kRounding + 4.0 * kLongRounding * GetParam().softest);
  const auto audited = by_cholmod->make_evaluator();
  const Evaluation refined = audited->audit(x);
  ASSERT_TRUE(refined.ok());
  EXPECT_NEAR(refined.cost, exact->cost, *audited->health().cost_error);
  const double roundings = kRounding * static_cast<double>(by_cholmod->residual_count());
  EXPECT_LE(*audited->health().cost_error, (1e-12 + roundings) * exact->cost) << "says nothing";

  // In a race: 1e-10 of u is what is promised, of the cost twice that by the size of u beside the residual.
  const double relative = std::sqrt(2.0 * exact->cost), noise = 2e-10 * relative * (1.0 + relative);
  for (const auto& racing : {by_lanes, by_cholmod}) {
    const auto evaluator = racing->make_evaluator();
    const Evaluation value = evaluator->value(x);
    ASSERT_TRUE(value.ok());
    EXPECT_NEAR(value.cost, exact->cost, noise) << racing->scene().solver;
    const Evaluation walk = evaluator->moves()->reset(x);
    ASSERT_TRUE(walk.ok());
    EXPECT_NEAR(walk.cost, exact->cost, noise) << racing->scene().solver;
  }
}

INSTANTIATE_TEST_SUITE_P(HardCases, BlockStability, testing::ValuesIn(cases()),
                         [](const auto& p) { return p.param.name; });

// Betti, on springs over twelve decades.
TEST(BlockEquilibrium, IsReciprocal) {
  Scene scene = make_block()->scene();
  RandomStream random(5);
  std::vector<double> k(scene.net.springs.size());
  for (double& e : k) e = std::pow(10.0, random.uniform(-6.0, 6.0));
  const Freedoms freedoms = scene.net.freedoms();
  const std::size_t a = freedoms.at(13, 2), b = freedoms.at(26, 1);
  LoadCase load{"unit", 0, std::vector<double>(freedoms.size(), 0.0), std::vector<double>(freedoms.size(), 1.0)};
  scene.loads.loads = {load, load};
  scene.loads.loads[0].forces[a] = scene.loads.loads[1].forces[b] = 1.0;
  scene.loads.groups = {{{{0, 0, 0.0}, {0, 1, 0.0}, {0, 2, 0.0}, {2, 1, 0.0}, {2, 2, 0.0}, {6, 2, 0.0}}}};
  const State state = ElasticProblem(scene).solve(k);
  ASSERT_EQ(state.status, Status::ok) << state.message;
  const double size = std::abs(state.loads[0].displacement[a]) + std::abs(state.loads[1].displacement[b]);
  EXPECT_NEAR(state.loads[0].displacement[b], state.loads[1].displacement[a], 8 * kRounding * size);
}

// Supports moved as a rigid body moves, no forces: the net follows, and no spring is stretched.
TEST(BlockEquilibrium, ARigidMotionNeedsNoForce) {
  Scene scene = make_block({.supports = "minimal"})->scene();
  const Vector turn = {0.125, -0.25, 0.375};
  const auto rigid = [&](std::size_t node) {
    Vector u = cross(turn, scene.net.nodes[node]);
    for (std::size_t a = 0; a < 3; ++a) u[a] += 0.3 - 0.2 * static_cast<double>(a);
    return u;
  };
  for (Support& s : scene.loads.groups[0].supports) s.value = rigid(s.node)[s.axis];
  for (LoadCase& load : scene.loads.loads) std::ranges::fill(load.forces, 0.0);
  RandomStream random(9);
  std::vector<double> k(scene.net.springs.size());
  for (double& e : k) e = std::pow(10.0, random.uniform(-3.0, 3.0));
  const State state = ElasticProblem(scene).solve(k);
  ASSERT_EQ(state.status, Status::ok) << state.message;
  for (std::size_t i = 0; i < scene.net.nodes.size(); ++i)
    // Directions are rounded: ε · 10³ of contrast.
    EXPECT_LT(distance(scene.net.freedoms().vector_at(state.loads[0].displacement, i), rigid(i)), 1e-12);
  for (const double force : state.loads[0].bearing) EXPECT_NEAR(force, 0.0, 1e-12);
}

TEST(BlockEquilibrium, ARefusedSolveNamesTheNode) {
  const auto block = make_block({.topology = "single"});
  std::vector<double> k;
  for (const Spring& s : block->net().springs) k.push_back(axes_of(s) > 1 ? 1e-15 : 1.0);
  const State state = block->solve(k);
  ASSERT_EQ(state.status, Status::ill_conditioned) << state.message;
  EXPECT_NE(state.message.find("node "), std::string::npos) << state.message;
}

}  // namespace
}  // namespace nodal::elastic
