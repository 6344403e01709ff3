// SPDX-License-Identifier: GPL-3.0-or-later
// The equilibrium solver: statuses, prescribed displacements, refinement, bad stiffnesses.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../plate.h"
#include "system/equilibrium.h"

namespace nodal::elastic {
namespace {

// A scene of n nodes in a row on the x axis: a chain, held in y everywhere.
Scene chain(std::size_t nodes, std::vector<Support> supports) {
  Scene scene;
  scene.net.body = plane::rectangle_body({0, 0}, {static_cast<double>(nodes - 1), 1.0});
  for (std::size_t i = 0; i < nodes; ++i) scene.net.nodes.push_back({static_cast<double>(i), 0.0});
  for (std::size_t i = 0; i + 1 < nodes; ++i) scene.net.springs.push_back({i, i + 1, 1.0, {1.0, 0.0}});
  for (std::size_t i = 0; i < nodes; ++i) supports.push_back({i, 1, 0.0});
  scene.loads.groups.push_back({std::move(supports)});
  LoadCase load{"pull", 0, std::vector<double>(2 * nodes, 0.0), std::vector<double>(2 * nodes, 0.0)};
  scene.loads.loads.push_back(std::move(load));
  return scene;
}

// Springs 1, 2, 4 in a row, ends held at 0 and 0.7: the force 0.7/(1 + 1/2 + 1/4) = 0.4 in each.
TEST(Equilibrium, TakesPrescribedDisplacements) {
  const Scene scene = chain(4, {{0, 0, 0.0}, {3, 0, 0.7}});
  const EquilibriumGroup group(scene, 0);
  Equilibrium equilibrium(group);
  const std::vector<double> k = {1.0, 2.0, 4.0};
  ASSERT_EQ(equilibrium.factorize(k), Status::ok);
  ASSERT_EQ(equilibrium.solve_loads(), Status::ok);
  const double* u = equilibrium.displacement(0).data();
  for (std::size_t e = 0; e < 3; ++e) EXPECT_NEAR(k[e] * group.elongation(e, u), 0.4, 1e-15);
}

TEST(Equilibrium, RefinesPrescribedDisplacementsToo) {
  const Scene scene = chain(3, {{0, 0, 0.0}, {2, 0, 1.0}});
  const EquilibriumGroup group(scene, 0);
  Equilibrium equilibrium(group);
  const std::vector<double> k = {1e12, 1.0};
  ASSERT_EQ(equilibrium.factorize(k), Status::ok);
  ASSERT_EQ(equilibrium.solve_loads(), Status::ok);
  ASSERT_EQ(equilibrium.refine().status, Status::ok);
  // u = k₂/(k₁ + k₂) to the last digit but one.
  EXPECT_NEAR(equilibrium.displacement(0)[group.place()[2]] / (1.0 / (1e12 + 1.0)), 1.0, 4e-16);
}

// Derivatives with a support that is held away from zero: the adjoint formulas hold unchanged.
TEST(Equilibrium, GradientHoldsWithPrescribedDisplacements) {
  const auto plate = make_plate();
  Scene scene = plate->scene();
  for (Support& s : scene.loads.groups[0].supports) s.value = 0.1 * static_cast<double>(1 + s.node);
  const ElasticProblem problem(scene);
  const auto evaluator = problem.make_evaluator();
  std::vector<double> x(problem.space().start().begin(), problem.space().start().end()), gradient(x.size());
  ASSERT_TRUE(evaluator->value_and_gradient(x, gradient).ok());
  for (const std::size_t i : {std::size_t{0}, std::size_t{30}, std::size_t{71}}) {
    const double h = 1e-4, xi = x[i];
    x[i] = xi + h;
    const double above = evaluator->audit(x).cost;
    x[i] = xi - h;
    const double below = evaluator->audit(x).cost;
    x[i] = xi;
    // Second-order differences: h² = 1e-8 relative truncation.
    EXPECT_NEAR((above - below) / (2 * h), gradient[i], 1e-6 * std::abs(gradient[i]) + 1e-10);
  }
}

TEST(Equilibrium, NamesTheNodeThatGivesWay) {
  const auto plate = make_plate();
  std::vector<double> k(plate->net().springs.size(), 1.0);
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Spring& s = plate->net().springs[e];
    if (s.first == 12 || s.second == 12) k[e] = 0.0;
  }
  const State state = plate->solve(k);
  EXPECT_EQ(state.status, Status::not_positive_definite);
  EXPECT_EQ(state.message, "the net is a mechanism or not supported: it gives way at node 12 (support group 0)");
}

TEST(Equilibrium, RefusesANegativeStiffnessThatSoftensTheNet) {
  const auto plate = make_plate();
  std::vector<double> k(plate->net().springs.size(), 1.0);
  k[10] = -50.0;
  EXPECT_EQ(plate->solve(k).status, Status::not_positive_definite);
}

TEST(Equilibrium, RefusesNumbersThatCannotBeComputedWith) {
  const auto plate = make_plate();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e-310}) {
    std::vector<double> k(plate->net().springs.size(), 1.0);
    k[3] = bad;
    const State state = plate->solve(k);
    EXPECT_EQ(state.status, Status::invalid_input);
    EXPECT_TRUE(state.message.starts_with("spring (1, 2) has stiffness")) << state.message;
  }
}

TEST(Equilibrium, ReturnsAStatusForCoordinatesThatAreNoNumbers) {
  const auto plate = make_plate();
  const auto evaluator = plate->make_evaluator();
  std::vector<double> x(plate->space().start().begin(), plate->space().start().end());
  for (const double bad : {std::nan(""), 1e4, -730.0}) {  // no number, infinite, denormal: k = 9e-318
    x[7] = bad;
    EXPECT_EQ(evaluator->value(x).status, Status::invalid_input);
  }
}

// k = 1e-300 … 1e300 is nothing but a change of units: the same digits, since displacements merely scale.
TEST(Equilibrium, WorksInAnyUnitOfStiffness) {
  const auto plate = make_plate();
  const std::vector<double> unit(plate->net().springs.size(), 1.0);
  const State expected = plate->solve(unit);
  for (const int exponent : {-900, -40, 40, 900}) {
    std::vector<double> k = unit;
    for (double& e : k) e = std::ldexp(e, exponent);
    const auto evaluator = plate->make_evaluator();
    const State state = plate->solve(k);
    if (std::abs(exponent) > 500)
      continue;  // displacements squared leave the range of doubles: a status, checked below
    ASSERT_EQ(state.status, Status::ok);
    for (std::size_t i = 0; i < expected.loads[0].displacement.size(); ++i)
      EXPECT_EQ(state.loads[0].displacement[i], std::ldexp(expected.loads[0].displacement[i], -exponent));
  }
}

// A stiff inclusion of 1e12: refined to rounding, where a plain solve has lost a dozen digits. The reference is the
// limit of a rigid inclusion, which 1e12 and 1e13 both meet to 1e-12.
TEST(Equilibrium, RefinesAStiffInclusion) {
  const auto plate = make_plate({.counts = "[8, 8]"});
  const auto with_inclusion = [&](double stiff) {
    std::vector<double> k(plate->net().springs.size(), 1.0);
    for (std::size_t e = 0; e < k.size(); ++e) {
      const Spring& s = plate->net().springs[e];
      const auto inside = [&](std::size_t node) {
        return node % 8 >= 3 && node % 8 <= 4 && node / 8 >= 3 && node / 8 <= 4;
      };
      if (inside(s.first) && inside(s.second)) k[e] = stiff;
    }
    return plate->solve(k);
  };
  const State a = with_inclusion(1e12), b = with_inclusion(1e13);
  ASSERT_EQ(a.status, Status::ok);
  ASSERT_EQ(b.status, Status::ok);
  EXPECT_NEAR(a.quality / b.quality, 1.0, 1e-11);
  EXPECT_LT(*a.health.residual, 1e-15);
}

// Stiffnesses spread over 24 decades at random: more than double precision can carry, and said so.
TEST(Equilibrium, SaysWhenDoublePrecisionIsNotEnough) {
  const auto plate = make_plate({.counts = "[8, 8]"});
  RandomStream random(5);
  int refused = 0;
  for (int i = 0; i < 10; ++i) {
    std::vector<double> k(plate->net().springs.size());
    for (double& e : k) e = std::pow(10.0, random.uniform(-12.0, 12.0));
    const Status status = plate->solve(k).status;
    refused += status == Status::ill_conditioned || status == Status::not_positive_definite;
  }
  EXPECT_GT(refused, 0);
}

TEST(Equilibrium, FindsNothingToFitWhereTheReferenceIsZero) {
  Scene scene = make_plate()->scene();
  for (LoadCase& load : scene.loads.loads) std::ranges::fill(load.reference, 0.0);
  EXPECT_THROW(ElasticProblem{scene}, InputError);
}

TEST(Equilibrium, SimplicialAndSupernodalAgree) {
  const auto simplicial = make_plate({.counts = "[12, 9]", .solver = "simplicial"});
  const auto supernodal = make_plate({.counts = "[12, 9]", .solver = "supernodal"});
  const std::vector<double> k = simplicial->stiffness(simplicial->space().start());
  const State a = simplicial->solve(k), b = supernodal->solve(k);
  EXPECT_NEAR(a.quality, b.quality, 1e-13 * a.quality);
}

// Betti: the displacement at i under a unit force at j equals that at j under one at i.
TEST(Equilibrium, IsReciprocal) {
  const auto plate = make_plate();
  Scene scene = plate->scene();
  const auto unit_force = [&](std::size_t freedom) {
    LoadCase load{"unit", 0, std::vector<double>(50, 0.0), std::vector<double>(50, 1.0)};
    load.forces[freedom] = 1.0;
    return load;
  };
  const std::size_t a = 2 * 13, b = 2 * 22 + 1;
  scene.loads.loads = {unit_force(a), unit_force(b)};
  scene.loads.groups.resize(1);
  const ElasticProblem problem(scene);
  const State state = problem.solve(problem.stiffness(problem.space().start()));
  EXPECT_NEAR(state.loads[0].displacement[b], state.loads[1].displacement[a], 1e-14);
}

}  // namespace
}  // namespace nodal::elastic
