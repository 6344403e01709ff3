// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of equilibria whatever the stiffnesses and units: against extended precision, other solvers, itself.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <nodal/elastic/extended_equilibrium.h>
#include <nodal/exhibit.h>

#include "../plate.h"

namespace nodal::elastic {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

std::vector<double> random_stiffness(const Scene& scene, double decades, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> k(scene.net.springs.size());
  for (double& e : k) e = std::pow(10.0, random.uniform(-decades, decades));
  return k;
}

// Springs of the right half `contrast` times softer.
std::vector<double> half_soft(const Scene& scene, double contrast) {
  std::vector<double> k(scene.net.springs.size(), 1.0);
  const double middle = extent_of(scene.net.nodes).along(0) / 2;
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Spring& s = scene.net.springs[e];
    if (scene.net.nodes[s.first][0] + scene.net.nodes[s.second][0] > 2 * middle) k[e] = 1.0 / contrast;
  }
  return k;
}

// Springs 1, 2, 4 in a row, ends held at 0 and 0.7: the force 0.7/(1 + 1/2 + 1/4) = 0.4 in each.
TEST(ExtendedEquilibrium, MeetsTheClosedFormOfAChain) {
  Scene scene;
  for (std::size_t i = 0; i < 4; ++i) scene.net.nodes.push_back({static_cast<double>(i), 0.0});
  for (std::size_t i = 0; i < 3; ++i) scene.net.springs.push_back({i, i + 1, 1.0, {1.0, 0.0}});
  scene.loads.groups = {{{{0, 0, 0.0}, {0, 1, 0.0}, {1, 1, 0.0}, {2, 1, 0.0}, {3, 0, 0.7}, {3, 1, 0.0}}}};
  scene.loads.loads = {{"pull", 0, std::vector<double>(8, 0.0), std::vector<double>(8, 1.0)}};
  const auto exact = solve_extended(scene, std::vector<double>{1.0, 2.0, 4.0});
  ASSERT_TRUE(exact.has_value());
  // 0.7 is a double: that is all that the results may be off by.
  EXPECT_NEAR(exact->displacements[0][2], 0.4, kEpsilon);
  EXPECT_NEAR(exact->displacements[0][4], 0.6, kEpsilon);
}

TEST(ExtendedEquilibrium, HasNoneForAMechanismOrWhatIsNoNumber) {
  const Scene scene = make_plate()->scene();
  std::vector<double> k(scene.net.springs.size(), 0.0);
  EXPECT_FALSE(solve_extended(scene, k).has_value());
  std::ranges::fill(k, 1.0);
  EXPECT_TRUE(solve_extended(scene, k).has_value());
  k[3] = std::nan("");
  EXPECT_FALSE(solve_extended(scene, k).has_value());
}

// The bound is what health says; it must hold as it stands.
TEST(Stability, TheCostIsAsExactAsHealthSays) {
  const auto plate = make_plate();
  const auto evaluator = plate->make_evaluator();
  int solved = 0;
  for (const double decades : {0.0, 1.0, 3.0, 6.0, 9.0, 11.0})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      std::vector<double> x(plate->space().size());
      plate->parameters().coordinates(random_stiffness(plate->scene(), decades, seed), x);
      const Evaluation result = evaluator->audit(x);
      if (!result.ok()) continue;
      ++solved;
      const auto exact = solve_extended(plate->scene(), plate->stiffness(x));
      ASSERT_TRUE(exact.has_value());
      EXPECT_NEAR(result.cost, exact->cost, *evaluator->health().cost_error) << decades << " decades, seed " << seed;
      EXPECT_LE(*evaluator->health().cost_error, 1e-12 * exact->cost) << "says nothing";
    }
  EXPECT_GE(solved, 100);  // up to nine decades either way nearly every draw can be solved
}

TEST(Stability, ARefusedSolveSaysHowMuchWasLost) {
  const auto plate = make_plate({.counts = "[8, 8]"});
  std::vector<double> k(plate->net().springs.size(), 1.0);
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Vector& d = plate->net().springs[e].direction;
    if (d[0] * d[1] != 0.0) k[e] = 1e-14;
  }
  const State state = plate->solve(k);
  ASSERT_EQ(state.status, Status::ill_conditioned) << state.message;
  EXPECT_GT(state.health.error_estimate.value_or(0.0), 0.01);
  EXPECT_NE(state.message.find("node "), std::string::npos) << state.message;
}

// Units of length and force by powers of two, 2^-30 and 2^10 being about nanometres and kilometres.
TEST(Stability, UnitsByPowersOfTwoChangeNoDigit) {
  const auto plate = make_plate();
  const std::vector<double> k = random_stiffness(plate->scene(), 3.0, 7);
  const State expected = plate->solve(k);
  ASSERT_EQ(expected.status, Status::ok);
  struct Units {
    int length, force;
  };
  for (const Units& unit : {Units{-30, 0}, {10, 0}, {10, -30}, {0, 900}, {500, -400}, {-900, 60}}) {
    Scene scene = plate->scene();
    std::vector<double> scaled = k;
    for (double& e : scaled) e = std::ldexp(e, unit.force - unit.length);
    for (LoadCase& load : scene.loads.loads) {
      for (double& f : load.forces) f = std::ldexp(f, unit.force);
      for (double& u : load.reference) u = std::ldexp(u, unit.length);
    }
    const ElasticProblem problem(scene);
    const State state = problem.solve(scaled);
    ASSERT_EQ(state.status, Status::ok) << unit.length << ", " << unit.force << ": " << state.message;
    EXPECT_EQ(state.relative_error, expected.relative_error);
    EXPECT_EQ(state.quality, std::ldexp(expected.quality, unit.length));
    for (std::size_t l = 0; l < state.loads.size(); ++l)
      for (std::size_t i = 0; i < state.loads[l].displacement.size(); ++i)
        EXPECT_EQ(state.loads[l].displacement[i], std::ldexp(expected.loads[l].displacement[i], unit.length));
  }
}

// Another numbering eliminates in another order; refined, both are within a few roundings of the exact solution.
TEST(Stability, TheNumberingOfNodesDoesNotMatter) {
  const auto plate = make_plate({.counts = "[6, 5]"});
  const std::vector<double> k = random_stiffness(plate->scene(), 6.0, 3);
  const std::size_t n = plate->net().nodes.size();
  std::vector<std::size_t> to(n);
  std::iota(to.begin(), to.end(), std::size_t{0});
  RandomStream random(11);
  for (std::size_t i = n; i > 1; --i) std::swap(to[i - 1], to[random.index(i)]);
  Scene scene = plate->scene();
  for (std::size_t i = 0; i < n; ++i) scene.net.nodes[to[i]] = plate->net().nodes[i];
  find_border(scene.net);
  for (Spring& s : scene.net.springs) s.first = to[s.first], s.second = to[s.second];
  for (SupportGroup& group : scene.loads.groups) {
    for (Support& s : group.supports) s.node = to[s.node];
    std::ranges::sort(group.supports, {}, [](const Support& s) { return 2 * s.node + s.axis; });
  }
  for (std::size_t l = 0; l < scene.loads.loads.size(); ++l)
    for (std::size_t i = 0; i < 2 * n; ++i) {
      scene.loads.loads[l].forces[2 * to[i / 2] + i % 2] = plate->scene().loads.loads[l].forces[i];
      scene.loads.loads[l].reference[2 * to[i / 2] + i % 2] = plate->scene().loads.loads[l].reference[i];
    }
  const State a = plate->solve(k), b = ElasticProblem(scene).solve(k);
  ASSERT_EQ(a.status, Status::ok);
  ASSERT_EQ(b.status, Status::ok);
  for (std::size_t l = 0; l < a.loads.size(); ++l)
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const double expected = a.loads[l].displacement[i];
      EXPECT_NEAR(b.loads[l].displacement[2 * to[i / 2] + i % 2], expected, 4 * kEpsilon * std::abs(expected) + 1e-300);
    }
}

// Betti, on springs over twelve decades.
TEST(Stability, IsReciprocalAtAnyContrast) {
  Scene scene = make_plate()->scene();
  const std::vector<double> k = random_stiffness(scene, 6.0, 5);
  const std::size_t a = 2 * 13, b = 2 * 22 + 1;
  LoadCase load{"unit", 0, std::vector<double>(50, 0.0), std::vector<double>(50, 1.0)};
  scene.loads.loads = {load, load};
  scene.loads.loads[0].forces[a] = scene.loads.loads[1].forces[b] = 1.0;
  scene.loads.groups.resize(1);
  const State state = ElasticProblem(scene).solve(k);
  ASSERT_EQ(state.status, Status::ok);
  // An entry can be small beside the vector that is exact to rounding: that vector's size counts.
  const double size = std::abs(state.loads[0].displacement[a]) + std::abs(state.loads[1].displacement[b]);
  EXPECT_NEAR(state.loads[0].displacement[b], state.loads[1].displacement[a], 8 * kEpsilon * size);
}

// Supports moved as a rigid body moves, no forces: the net follows, and no spring is stretched.
TEST(Stability, ARigidMotionNeedsNoForce) {
  Scene scene = make_plate({.supports = "minimal"})->scene();
  const auto rigid = [&](std::size_t node, std::size_t axis) {
    const Vector& p = scene.net.nodes[node];
    return axis == 0 ? 0.3 - 0.125 * p[1] : -0.2 + 0.125 * p[0];
  };
  for (Support& s : scene.loads.groups[0].supports) s.value = rigid(s.node, s.axis);
  for (LoadCase& load : scene.loads.loads) std::ranges::fill(load.forces, 0.0);
  const State state = ElasticProblem(scene).solve(random_stiffness(scene, 3.0, 9));
  ASSERT_EQ(state.status, Status::ok);
  for (std::size_t i = 0; i < 2 * scene.net.nodes.size(); ++i)
    EXPECT_NEAR(state.loads[0].displacement[i], rigid(i / 2, i % 2),
                1e-12);  // directions are rounded: ε · 10³ of contrast
  for (const double force : state.loads[0].bearing) EXPECT_NEAR(force, 0.0, 1e-12);
}

// The free block of K, as a textbook assembles it.
Eigen::MatrixXd assemble(const Scene& scene, std::span<const double> k, std::vector<Eigen::Index>& unknown) {
  unknown.assign(2 * scene.net.nodes.size(), 0);
  for (const Support& s : scene.loads.groups[0].supports) unknown[2 * s.node + s.axis] = -1;
  Eigen::Index free = 0;
  for (Eigen::Index& i : unknown)
    if (i >= 0) i = free++;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(free, free);
  for (std::size_t e = 0; e < k.size(); ++e) {
    const Spring& s = scene.net.springs[e];
    const std::size_t freedom[] = {2 * s.first, 2 * s.first + 1, 2 * s.second, 2 * s.second + 1};
    const double b[] = {-s.direction[0], -s.direction[1], s.direction[0], s.direction[1]};
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t q = 0; q < 4; ++q)
        if (unknown[freedom[p]] >= 0 && unknown[freedom[q]] >= 0)
          matrix(unknown[freedom[p]], unknown[freedom[q]]) += k[e] * b[p] * b[q];
  }
  return matrix;
}

// Condition about 1e5 on ten by seven nodes and two decades: 1e-10 leaves room for what plain solves lose.
TEST(Stability, SimplicialSupernodalEigenAndDenseAgree) {
  const auto simplicial = make_plate({.counts = "[10, 7]", .solver = "simplicial"});
  const auto supernodal = make_plate({.counts = "[10, 7]", .solver = "supernodal"});
  const Scene& scene = simplicial->scene();
  const std::vector<double> k = random_stiffness(scene, 1.0, 4);
  const State a = simplicial->solve(k), b = supernodal->solve(k);
  ASSERT_EQ(a.status, Status::ok);
  ASSERT_EQ(b.status, Status::ok);
  std::vector<Eigen::Index> unknown;
  const Eigen::MatrixXd matrix = assemble(scene, k, unknown);
  Eigen::VectorXd force(matrix.rows());
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (unknown[i] >= 0) force[unknown[i]] = scene.loads.loads[0].forces[i];
  const Eigen::VectorXd dense = matrix.llt().solve(force);
  const Eigen::SparseMatrix<double> compressed = matrix.sparseView();
  const Eigen::VectorXd sparse = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(compressed).solve(force);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    if (unknown[i] < 0) continue;
    const double u = a.loads[0].displacement[i];
    EXPECT_NEAR(b.loads[0].displacement[i], u, 4 * kEpsilon * std::abs(u) + 1e-300);
    EXPECT_NEAR(dense[unknown[i]], u, 1e-10 * dense.norm());
    EXPECT_NEAR(sparse[unknown[i]], u, 1e-10 * dense.norm());
  }
}

// Central differences of the cost in extended precision, step h in ln k: h² = 1e-8 of truncation, 1e-12 of rounding.
TEST(Stability, TheGradientHoldsAtAnyContrast) {
  const auto plate = make_plate({.bounds = "[1e-14, 1e4]"});
  for (const double contrast : {1.0, 1e6, 1e12}) {
    const auto evaluator = plate->make_evaluator();
    std::vector<double> x(plate->space().size()), gradient(x.size());
    plate->parameters().coordinates(half_soft(plate->scene(), contrast), x);
    ASSERT_TRUE(evaluator->value_and_gradient(x, gradient).ok());
    double size = 0.0;
    for (const double g : gradient) size = std::max(size, std::abs(g));
    for (const std::size_t i : {std::size_t{0}, std::size_t{17}, std::size_t{30}, std::size_t{48}, std::size_t{71}}) {
      constexpr double h = 1e-4;
      const auto cost_at = [&](double step) {
        std::vector<double> y = x;
        y[i] += step;
        return solve_extended(plate->scene(), plate->stiffness(y))->cost;
      };
      EXPECT_NEAR((cost_at(h) - cost_at(-h)) / (2 * h), gradient[i], 1e-7 * size) << contrast << ", spring " << i;
    }
  }
}

// What the program says of a best known quality: the refined one has nearly all of the digits that the exact one has.
TEST(ExtendedEquilibrium, SaysHowManyDigitsOfAQualityHold) {
  for (const char* more : {"", "prior = { weight = 0.3 }\n"}) {
    const auto problem = make_plate({.more = more});
    const std::vector<double> k = random_stiffness(problem->scene(), 0.5, 3);
    const State state = problem->solve(k);
    const double quality = state.prior ? state.prior->quality : state.quality;
    EXPECT_NEAR(exhibit_of(*problem)->exact_quality(k).value_or(0.0), quality, 1e-13 * quality) << more;
  }
  const auto large = make_plate({.counts = "[20, 20]", .size = "[19.0, 19.0]"});
  EXPECT_EQ(exhibit_of(*large)->exact_quality(large->start_stiffness()), std::nullopt) << "it would take seconds";
}

TEST(Stability, NoForceThatIsNoNumberGetsThrough) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Scene scene = make_plate()->scene();
    scene.loads.loads[2].forces[9] = bad;
    const ElasticProblem problem(scene);
    const State state = problem.solve(scene.initial_stiffness);
    EXPECT_EQ(state.status, Status::invalid_input);
    EXPECT_TRUE(state.message.starts_with("load 'shear-x' has force")) << state.message;
    EXPECT_NE(state.message.find("node 4"), std::string::npos) << state.message;
    const auto evaluator = problem.make_evaluator();
    EXPECT_EQ(evaluator->value(problem.space().start()).status, Status::invalid_input);
    EXPECT_EQ(evaluator->moves()->reset(problem.space().start()).status, Status::invalid_input);
  }
}

TEST(Stability, ASpringWithoutLengthIsNamed) {
  Scene scene = make_plate()->scene();
  scene.net.springs[5].direction = {std::nan(""), std::nan("")};
  const State state = ElasticProblem(scene).solve(scene.initial_stiffness);
  EXPECT_EQ(state.status, Status::invalid_input);
  EXPECT_NE(state.message.find("has no direction"), std::string::npos) << state.message;
}

}  // namespace
}  // namespace nodal::elastic
