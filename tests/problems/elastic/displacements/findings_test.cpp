// SPDX-License-Identifier: GPL-3.0-or-later
// The longest stable explicit step against frequencies that are known: of a chain, and by a dense eigenvalue solver.
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Eigenvalues>

#include "../block.h"
#include "displacements/findings.h"
#include "displacements/highest_frequency.h"

namespace nodal::elastic {
namespace {

Net chain(std::size_t springs, double mass) {
  Net net;
  for (std::size_t i = 0; i <= springs; ++i) {
    net.nodes.push_back({0.5 * static_cast<double>(i), 0.0, 0.0});
    net.masses.push_back(i == 0 || i == springs ? 0.5 * mass : mass);
  }
  for (std::size_t e = 0; e < springs; ++e) net.springs.push_back(make_spring(net.nodes, e, e + 1));
  return net;
}

// Its highest frequency is 2 √(k/m), all nodes against their neighbours: here the bound is the frequency itself.
TEST(StableStep, OfAChainIsExact) {
  const Net net = chain(7, 3.0);
  EXPECT_DOUBLE_EQ(stable_step_of(net, std::vector<double>(7, 12.0)).value(), std::sqrt(3.0 / 12.0));
}

TEST(StableStep, IsNoneWithoutMasses) {
  Net net = chain(7, 3.0);
  net.masses[4] = 0.0;
  EXPECT_FALSE(stable_step_of(net, std::vector<double>(7, 12.0)).has_value());
  net.masses.clear();
  EXPECT_FALSE(stable_step_of(net, std::vector<double>(7, 12.0)).has_value());
}

// ω_max of the free net, which no support raises.
double highest_frequency(const Net& net, std::span<const double> stiffness) {
  const Freedoms freedoms = net.freedoms();
  const auto size = static_cast<Eigen::Index>(freedoms.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    const Spring& s = net.springs[e];
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    for (std::size_t axis = 0; axis < net.dimension; ++axis) {
      b[static_cast<Eigen::Index>(freedoms.at(s.first, axis))] = -s.direction[axis] / std::sqrt(net.masses[s.first]);
      b[static_cast<Eigen::Index>(freedoms.at(s.second, axis))] = s.direction[axis] / std::sqrt(net.masses[s.second]);
    }
    k += stiffness[e] * b * b.transpose();
  }
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
}

TEST(StableStep, IsBelowWhatTheHighestFrequencyAllows) {
  const auto problem = as_elastic(
      parse_study("[problem]\nkind = \"elastic\"\npoints = { counts = [5, 4] }\nmasses = { form = \"least-norm\" }\n",
                  "study.toml", components()));
  RandomStream random(2);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> stiffness(problem->net().springs.size());
    for (double& k : stiffness) k = std::exp(random.uniform(-3.0, 3.0));
    const double exact = 2.0 / highest_frequency(problem->net(), stiffness);
    const double step = stable_step_of(problem->net(), stiffness).value();
    EXPECT_LE(step, exact);
    EXPECT_GT(step, 0.5 * exact);  // no less than half, or nobody would use it
    const double estimate = 2.0 / highest_frequency_estimate(problem->net(), stiffness);  // of all 40 freedoms
    EXPECT_NEAR(estimate, exact, 1e-12 * exact);
    const double rough = 2.0 / highest_frequency_estimate(problem->net(), stiffness, 10);
    EXPECT_GE(rough, exact * (1.0 - 1e-12));
    EXPECT_LT(rough, 1.1 * exact);
  }
}

TEST(StableStep, IsAFindingOfStatesAndAudits) {
  const auto problem = as_elastic(
      parse_study("[problem]\nkind = \"elastic\"\nmasses = { form = \"least-norm\" }\n", "study.toml", components()));
  const auto evaluator = problem->make_evaluator();
  ASSERT_TRUE(evaluator->audit(problem->space().start()).ok());
  const State state = problem->solve(problem->start_stiffness());
  for (const Health& health : {evaluator->health(), state.health}) {
    ASSERT_EQ(health.findings.size(), 2u);
    EXPECT_EQ(health.findings[1].name, "stable_step");
    EXPECT_DOUBLE_EQ(health.findings[1].value, stable_step_of(problem->net(), problem->start_stiffness()).value());
  }
  EXPECT_EQ(make_plate()->solve(make_plate()->start_stiffness()).health.findings.size(), 1u);
}

}  // namespace
}  // namespace nodal::elastic
