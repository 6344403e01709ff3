// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks in space: against closed forms, and a cantilever against beam theory.
#include <gtest/gtest.h>

#include "fields.h"
#include "finite_elements/block_mesh.h"
#include "finite_elements/converge.h"

namespace nodal::elastic::finite_elements {
namespace {

const Block kBrick = {.box = {{0, 0, 0}, {3, 2, 1}}, .planes = {{{}, {1.0}, {0.5}}}};
const Vector kAnchor = {0.0, 1.0, 0.5};

ConvergeResult converged(const Block& block, const std::vector<Group>& groups, const std::vector<Vector>& wanted,
                         double spacing) {
  const Compliance s = isotropic(2.0, 0.3);
  return converge([&](double h) { return block_mesh(block, h); }, {{{s}}, groups}, wanted, {.spacing = spacing});
}

std::vector<Vector> corners_and_middles() {
  std::vector<Vector> places;
  for (const double x : {0.0, 1.5, 3.0})
    for (const double y : {0.0, 1.0, 2.0})
      for (const double z : {0.0, 0.5, 1.0}) places.push_back({x, y, z});
  return places;
}

// A pull along x with the low face sliding; pure shear with the low face clamped; bending about z at rest.
TEST(FiniteElementBlocks, AgreeWithClosedForms) {
  const std::size_t low_x = face_label(0, false), low_y = face_label(1, false);
  Load pull{{{face_label(0, true), Vector{1, 0, 0}}}}, shear, bending;
  StressField bent;
  bent.centre = {1.5, 1.0, 0.5};
  bent.gradient[1][0][0] = 1.0;  // σ_xx = y − y_c
  for (std::size_t label = 0; label < 6; ++label) {
    shear.tractions.push_back({label, StressField{tensor(0, 0, 1)}});
    bending.tractions.push_back({label, bent});
  }
  const Group sliding{{{low_x, 0}, {kAnchor, 1}, {kAnchor, 2}, {Vector{0, 1, 0}, 1}}, {pull}};
  const Group clamped{{{low_y, 0}, {low_y, 1}, {low_y, 2}}, {shear}};
  const auto bent_at = [](const Vector& p) {
    const Vector x = p - Vector{1.5, 1.0, 0.5};
    return Vector{x[0] * x[1] / 2.0, -(x[0] * x[0] + 0.3 * (x[1] * x[1] - x[2] * x[2])) / 4.0,
                  -0.3 * x[1] * x[2] / 2.0};
  };
  Group resting{{}, {bending}};
  const std::vector<Vector> rest = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = k; axis < 3; ++axis) resting.prescribed.push_back({rest[k], axis, bent_at(rest[k])[axis]});
  const std::vector<Vector> wanted = corners_and_middles();
  const ConvergeResult result = converged(kBrick, {sliding, clamped, resting}, wanted, 2.0);
  EXPECT_TRUE(result.converged);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Vector& x = wanted[i];
    const Vector away = x - kAnchor;
    EXPECT_LT(distance(result.loads[0].displacements[i], {x[0] / 2.0, -0.15 * away[1], -0.15 * away[2]}), 1e-9);
    EXPECT_LT(distance(result.loads[1].displacements[i], {1.3 * x[1], 0, 0}), 1e-9);
    EXPECT_LT(distance(result.loads[2].displacements[i], bent_at(x)), 1e-9);
  }
  for (const LoadResult& load : result.loads) EXPECT_LE(load.error, 1e-9);
}

// Of length 10 and height 1, clamped at one end, a shear force at the other: w = F L³/3EI + 6 F L/5GA, within what
// clamping adds (some ν-dependent share of the height over the length).
TEST(FiniteElementBlocks, CantileverBendsAsABeam) {
  Block beam = {.box = {{0, 0, 0}, {10, 1, 1}}, .planes = {{{}, {0.5}, {0.5}}}};
  const std::size_t low = face_label(0, false);
  const Group group{{{low, 0}, {low, 1}, {low, 2}}, {{{{face_label(0, true), Vector{0, 0, -1e-3}}}}}};
  const ConvergeResult result =
      converge([&](double h) { return block_mesh(beam, h); }, {{{isotropic(1.0, 0.3)}}, {group}},
               {{10, 0.5, 0.5}, {5, 0.5, 0.5}}, {.spacing = 2.0, .tolerance = 1e-2});
  EXPECT_TRUE(result.converged);
  const double tip = 1e-3 * 1000.0 / (3.0 / 12.0) + 1.2 * 1e-3 * 10.0 * 2.6;
  EXPECT_NEAR(-result.loads[0].displacements[0][2], tip, 0.01 * tip);
  EXPECT_NEAR(-result.loads[0].displacements[1][2],
              1e-3 * (10.0 * 25.0 / 2.0 - 125.0 / 6.0) * 12.0 + 1.2e-3 * 5.0 * 2.6, 0.01 * tip);
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
