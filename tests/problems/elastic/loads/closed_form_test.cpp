// SPDX-License-Identifier: GPL-3.0-or-later
// What a homogeneous body answers a homogeneous stress with: plane and space against each other, and the work that
// forces do on their reference against the energy in the body.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

#include "loads/closed_form.h"
#include "loads/load_spec.h"
#include "stressed_bodies.h"

namespace nodal::elastic {
namespace {

constexpr double kRounding = 1e-13;  // of sums over some hundred nodes

Tensor symmetric(double xx, double yy, double zz, double xy, double yz, double zx) {
  return {{{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}}};
}

void expect_near(const Tensor& a, const Tensor& b, std::size_t dimension) {
  for (std::size_t i = 0; i < dimension; ++i)
    for (std::size_t j = 0; j < dimension; ++j) EXPECT_NEAR(a[i][j], b[i][j], 1e-15) << i << j;
}

TEST(Elasticity, PlaneStressIsSpaceWithoutStressAcross) {
  const Tensor stress = symmetric(1.3, -0.4, 0.0, 0.7, 0.0, 0.0);
  expect_near(kStress.elasticity(2).strain(stress), kStress.elasticity(3).strain(stress), 2);
}

TEST(Elasticity, PlaneStrainIsSpaceThatCannotStretchAcross) {
  const Tensor stress = symmetric(1.3, -0.4, kPoisson * (1.3 - 0.4), 0.7, 0.0, 0.0);
  const Tensor in_space = kStrain.elasticity(3).strain(stress);
  EXPECT_NEAR(in_space[2][2], 0.0, 1e-16);
  expect_near(kStrain.elasticity(2).strain(stress), in_space, 2);
}

TEST(Elasticity, AStrainIsSymmetric) {
  const Tensor strain = kStress.elasticity(3).strain(symmetric(1.0, 2.0, -3.0, 0.4, 0.5, 0.6));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(strain[i][j], strain[j][i]);
}

// Clapeyron: Σ f·u = V σ:ε, with the energies that textbooks have for one stress at a time.
void expect_energies(const Net& net, const Material& material, double young, SupportStyle style) {
  const double stress = 1.7, shear = kYoung / (2.0 * (1.0 + kPoisson));
  for (const LoadCase& load : make_basic_loads(net, material, stress, style).loads) {
    const double energy = kVolume * stress * stress / (load.name.starts_with("stretch") ? young : shear);
    EXPECT_NEAR(work(load) / energy, 1.0, kRounding) << load.name;
  }
}

TEST(ClosedForm, WorkOfBasicLoadsIsTheEnergyInTheBody) {
  for (const SupportStyle style : {SupportStyle::edge, SupportStyle::minimal}) {
    expect_energies(plate_net(), kStress, kYoung, style);
    expect_energies(plate_net(), kStrain, kYoung / (1.0 - kPoisson * kPoisson), style);
    expect_energies(block_net(), kStress, kYoung, style);
  }
}

double energy_density(const Tensor& s) {
  const double normal = s[0][0] * s[0][0] + s[1][1] * s[1][1] + s[2][2] * s[2][2];
  const double mixed = s[0][0] * s[1][1] + s[1][1] * s[2][2] + s[2][2] * s[0][0];
  const double shear = s[0][1] * s[0][1] + s[1][2] * s[1][2] + s[2][0] * s[2][0];
  return (normal - 2.0 * kPoisson * mixed + 2.0 * (1.0 + kPoisson) * shear) / kYoung;
}

// Those that are held in most axes first.
std::vector<std::size_t> nodes_of(const std::vector<Support>& supports) {
  std::map<std::size_t, int> axes;
  for (const Support& s : supports) ++axes[s.node];
  std::vector<std::size_t> nodes;
  for (const auto& [node, count] : axes) nodes.push_back(node);
  std::ranges::sort(nodes, std::greater<>(), [&](std::size_t node) { return axes[node]; });
  return nodes;
}

TEST(ClosedForm, AnyStressLeavesABodyAtRestWithItsEnergy) {
  const auto expect_energy = [](const Net& net, const Tensor& stress) {
    const LoadSet set = discretize({{"any", stress, Hold::resting}}, net, kStress);
    EXPECT_NEAR(work(set.loads[0]) / (kVolume * energy_density(stress)), 1.0, kRounding);
    const std::vector<Support>& supports = set.groups[0].supports;
    EXPECT_EQ(supports.size(), net.dimension * (net.dimension + 1) / 2);  // rigid motions, and no more
    std::vector<std::size_t> rest = nodes_of(supports);
    const auto u = displacements_at_rest(net, kStress.elasticity(net.dimension), stress, rest);
    for (const Support& s : supports) EXPECT_NEAR(u[net.freedoms().at(s.node, s.axis)], s.value, 1e-15);
  };
  expect_energy(plate_net(), symmetric(1.3, -0.4, 0.0, 0.7, 0.0, 0.0));
  expect_energy(block_net(), symmetric(1.3, -0.4, 0.6, 0.7, -1.1, 0.2));
}

// The side bears what would pull there, so its forces are missing; they would do no work.
TEST(ClosedForm, StressesWithoutShearSlideOnASide) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Tensor stress = symmetric(1.3, -0.4, 0.6, 0.0, 0.0, 0.0);
    const LoadSet set = discretize({{"any", stress, Hold::sliding, axis}}, block_net(), kStress);
    EXPECT_NEAR(work(set.loads[0]) / (kVolume * energy_density(stress)), 1.0, kRounding) << axis;
    double pull = 0.0;
    for (std::size_t f = axis; f < set.loads[0].forces.size(); f += 3) pull += set.loads[0].forces[f];
    EXPECT_NEAR(pull, stress[axis][axis] * kVolume / kSize[axis], kRounding) << axis;
  }
}

TEST(ClosedForm, WhatASideDoesNotBearHasNone) {
  const auto bears = [](const Tensor& stress, Hold hold) {
    try {
      (void)discretize({{"any", stress, hold, 1}}, block_net(), kStress);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  };
  const Tensor towards = symmetric(0.0, 0.0, 0.0, 1.0, 1.0, 0.0), within = symmetric(0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  EXPECT_TRUE(bears(towards, Hold::clamped));
  EXPECT_FALSE(bears(towards, Hold::sliding));
  EXPECT_FALSE(bears(within, Hold::clamped));
  EXPECT_FALSE(bears(within, Hold::sliding));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Tensor stretch{};
    stretch[axis][axis] = 1.0;
    EXPECT_FALSE(bears(stretch, Hold::clamped));
    EXPECT_TRUE(bears(stretch, Hold::sliding));
  }
}

std::vector<std::string> names(std::size_t dimension, SupportStyle style) {
  std::vector<std::string> all;
  for (const LoadSpec& spec : basic_load_specs(dimension, 1.0, style)) all.push_back(spec.name);
  return all;
}

TEST(BasicLoads, AreFourOrThreeInThePlaneNineOrSixInSpace) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(2, SupportStyle::edge), (Names{"stretch-x", "stretch-y", "shear-x", "shear-y"}));
  EXPECT_EQ(names(2, SupportStyle::minimal), (Names{"stretch-x", "stretch-y", "shear"}));
  EXPECT_EQ(names(3, SupportStyle::edge), (Names{"stretch-x", "stretch-y", "stretch-z", "shear-xy", "shear-yx",
                                                 "shear-yz", "shear-zy", "shear-zx", "shear-xz"}));
  EXPECT_EQ(names(3, SupportStyle::minimal),
            (Names{"stretch-x", "stretch-y", "stretch-z", "shear-xy", "shear-yz", "shear-zx"}));
}

}  // namespace
}  // namespace nodal::elastic
