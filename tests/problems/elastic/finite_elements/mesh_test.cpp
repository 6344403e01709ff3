// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of blocks, their refinements, and which cell a place is in.
#include <gtest/gtest.h>

#include <algorithm>

#include <nodal/error.h>

#include "fields.h"
#include "finite_elements/block_mesh.h"
#include "finite_elements/locator.h"
#include "finite_elements/solution.h"

namespace nodal::elastic::finite_elements {
namespace {

const Block kBlock = {.box = {{1.0, 2.0, 3.0}, {3.0, 3.0, 4.5}},
                      .planes = {{{1.7, 1.7 + 1e-12, 9.0}, {}, {}}},
                      .graded = {{{}, {2.0}, {}}},
                      .region = [](const Vector& x) -> std::size_t { return x[0] < 1.7 ? 1 : 0; }};

double volume_of(const Mesh& mesh, std::size_t region) {
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_GT(measure(mesh, c), 0.0);
    if (mesh.region[c] == region) sum += measure(mesh, c);
  }
  return sum;
}

// Area of the sides with a label along its axis; the other components must vanish, and it must point out of the block.
double side_area(const Mesh& mesh, std::size_t label) {
  Vector sum{};
  for (std::size_t s = 0; s < mesh.side_count(); ++s) {
    if (mesh.side_label[s] != label) continue;
    const auto nodes = mesh.side(s);
    const Vector twice =
        cross(mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]], mesh.nodes[nodes[2]] - mesh.nodes[nodes[0]]);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += 0.5 * twice[axis];
    for (const std::size_t node : nodes)
      EXPECT_NE(std::ranges::find(mesh.cell(mesh.side_cell[s]), node), mesh.cell(mesh.side_cell[s]).end());
  }
  EXPECT_NEAR(norm(sum), std::abs(sum[label / 2]), 1e-12);
  return label % 2 == 1 ? sum[label / 2] : -sum[label / 2];
}

void expect_block(const Mesh& mesh) {
  EXPECT_NEAR(volume_of(mesh, 0), 1.3 * 1.5, 1e-12);
  EXPECT_NEAR(volume_of(mesh, 1), 0.7 * 1.5, 1e-12);
  const std::array<double, 3> areas = {1.5, 3.0, 2.0};
  for (std::size_t label = 0; label < 6; ++label) EXPECT_NEAR(side_area(mesh, label), areas[label / 2], 1e-12) << label;
}

TEST(FiniteElementMesh, BlocksAreFilledAndLabelled) {
  const Mesh mesh = block_mesh(kBlock, 0.6);
  expect_block(mesh);
  const Mesh finer = refined(mesh);
  expect_block(finer);
  EXPECT_EQ(finer.cell_count(), 8 * mesh.cell_count());
  EXPECT_EQ(finer.side_count(), 4 * mesh.side_count());
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) EXPECT_EQ(finer.nodes[node], mesh.nodes[node]);
  expect_block(refined(finer));
}

TEST(FiniteElementMesh, PlanesAreGivenEvenAndGraded) {
  EXPECT_EQ(planes_across(kBlock, 2, 0.5), (std::vector<double>{3.0, 3.5, 4.0, 4.5}));
  const std::vector<double> given = planes_across(kBlock, 0, 5.0);
  ASSERT_EQ(given.size(), 3u);  // 9 is outside, and two are one
  EXPECT_DOUBLE_EQ(given[1], 1.7);
  const std::vector<double> graded = planes_across(kBlock, 1, 0.5);  // t = 0, 1/4, …
  ASSERT_EQ(graded.size(), 5u);
  EXPECT_DOUBLE_EQ(graded[1], 2.0 + 1.0 / 16.0);
  EXPECT_DOUBLE_EQ(graded[2], 2.25);
  Block both = kBlock;
  both.graded[1] = {2.0, 3.0};
  EXPECT_EQ(planes_across(both, 1, 0.5), (std::vector<double>{2.0, 2.125, 2.5, 2.875, 3.0}));
}

TEST(FiniteElementMesh, TooManyCellsAreRefusedBeforeTheyAreMade) {
  EXPECT_THROW((void)block_mesh(kBlock, 1e-4), Refusal);
}

TEST(FiniteElementMesh, PlacesAreFoundAgainInTheirCells) {
  const Mesh coarse = block_mesh(kBlock, 0.4), middle = refined(coarse), fine = refined(middle);
  const Locator locator(coarse);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Freedoms freedoms{3, fine.nodes.size()};
  std::vector<double> values(freedoms.size());  // x² + y z and so on, which quadratic shape functions have
  const auto value = [](const Vector& x) { return Vector{x[0] * x[0] + x[1] * x[2], x[0] * x[1], x[2] * x[2]}; };
  for (std::size_t node = 0; node < fine.nodes.size(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis) values[freedoms.at(node, axis)] = value(fine.nodes[node])[axis];
  for (int k = 0; k < 2000; ++k) {
    const Vector x = {1.0 + 2.0 * share(random), 2.0 + share(random), 3.0 + 1.5 * share(random)};
    const Location in_coarse = locator.locate(x), in_middle = descended(middle, in_coarse, x),
                   in_fine = descended(fine, in_middle, x);
    EXPECT_LT(Locator::distance(coarse, in_coarse), 1e-12);
    EXPECT_LT(Locator::distance(fine, in_fine), 1e-12);
    EXPECT_LT(distance(interpolated(fine, in_fine, values), value(x)), 1e-11);
  }
}

TEST(FiniteElementMesh, PlacesOutsideTakeTheNearestCell) {
  const Mesh mesh = block_mesh(kBlock, 0.3);
  const Locator locator(mesh);
  for (const Vector& x : {Vector{3.0 + 1e-6, 2.5, 4.0}, Vector{2.0, 3.0 + 1e-6, 3.2}, Vector{1.2, 2.4, 3.0 - 1e-6}}) {
    const Location found = locator.locate(x);
    EXPECT_NEAR(Locator::distance(mesh, found), 1e-6, 1e-10);
    for (const double weight : found.weights) EXPECT_GT(weight, -1e-4);
  }
  const Location far = locator.locate({30.0, 2.5, 4.0});
  EXPECT_GT(Locator::distance(mesh, far), 9.0);  // of 27: planes of sides may be nearer than sides
}

// ---- what is refused ---------------------------------------------------------------------------------------------

Problem held(std::vector<Prescribed> prescribed) {
  return {{{isotropic(1.0, 0.3)}, {isotropic(1.0, 0.3)}}, {{std::move(prescribed), {Load{}}}}};
}

std::string refusal_of(const Problem& problem) {
  try {
    (void)solve(block_mesh(kBlock, 1.0), problem);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(FiniteElementSolve, RefusesWhatHasNoSolution) {
  EXPECT_NE(refusal_of(held({{std::size_t{0}, 0}})).find("free to move"), std::string::npos);
  EXPECT_NE(refusal_of(held({{Vector{1.0, 2.0, 3.0}, 0}, {Vector{1.0, 2.0, 3.0}, 1}, {Vector{1.0, 2.0, 3.0}, 2}}))
                .find("free to move"),
            std::string::npos);
  EXPECT_NE(refusal_of(held({{Vector{1.1, 2.0, 3.0}, 0}})).find("no vertex"), std::string::npos);
  const std::vector<Prescribed> clamped = {{std::size_t{0}, 0}, {std::size_t{0}, 1}, {std::size_t{0}, 2}};
  EXPECT_EQ(refusal_of(held(clamped)), "");
  std::vector<Prescribed> torn = clamped;
  torn.push_back({Vector{1.0, 2.0, 3.0}, 1, 0.5});
  EXPECT_NE(refusal_of(held(torn)).find("0 m and at 0.5 m"), std::string::npos) << refusal_of(held(torn));
  Problem soft = held(clamped);
  soft.regions[1].compliance[0][0] = -1.0;
  EXPECT_NE(refusal_of(soft).find("positive definite"), std::string::npos);
  EXPECT_THROW((void)solve(block_mesh(kBlock, 1.0), held(clamped), 10.0), Refusal);
}

TEST(FiniteElementSolve, CallersErrorsAreNone) {
  Problem problem = held({{std::size_t{0}, 0}, {std::size_t{0}, 1}, {std::size_t{0}, 2}});
  problem.groups[0].loads[0].tractions = {{6, Vector{}}};
  EXPECT_THROW((void)solve(block_mesh(kBlock, 1.0), problem), std::invalid_argument);
  EXPECT_THROW((void)solve(block_mesh(kBlock, 1.0), held({{std::size_t{7}, 0}})), std::invalid_argument);
  problem.regions.pop_back();
  EXPECT_THROW((void)solve(block_mesh(kBlock, 1.0), problem), std::invalid_argument);
}

// A place that holds what pulls at the body is singular, and its force is told.
TEST(FiniteElementSolve, SaysWhatPlacesBear) {
  const Mesh mesh = block_mesh(kBlock, 0.5);
  Problem problem = held({{Vector{1.0, 2.0, 3.0}, 0},
                          {Vector{1.0, 2.0, 3.0}, 1},
                          {Vector{1.0, 2.0, 3.0}, 2},
                          {Vector{3.0, 2.0, 3.0}, 1},
                          {Vector{3.0, 2.0, 3.0}, 2},
                          {Vector{1.0, 3.0, 3.0}, 2}});
  problem.groups[0].loads[0].tractions = {{1, Vector{1.0, 0.0, 0.0}}};
  const double borne = solve(mesh, problem).loads[0].borne_by_places;
  EXPECT_NEAR(borne, 0.25, 0.1);  // all of the pull, in a sum of that, its bearing and what holds the turning
  problem.groups[0].loads[0].tractions.push_back({0, Vector{-1.0, 0.0, 0.0}});
  EXPECT_LT(solve(mesh, problem).loads[0].borne_by_places, 1e-12);
}

// Held as statics asks for, at a corner of the soft part, which lets the stiff one move far: what places bear is
// rounding of the stiff part's forces.
TEST(FiniteElementSolve, RoundingIsNotBorneByPlaces) {
  const std::vector<Prescribed> corners = {{Vector{1.0, 2.0, 3.0}, 0}, {Vector{1.0, 2.0, 3.0}, 1},
                                           {Vector{1.0, 2.0, 3.0}, 2}, {Vector{3.0, 2.0, 3.0}, 1},
                                           {Vector{3.0, 2.0, 3.0}, 2}, {Vector{1.0, 3.0, 3.0}, 2}};
  const Mesh mesh = block_mesh(kBlock, 0.5);
  Problem problem = held(corners);
  problem.regions = {{isotropic(1e10, 0.3)}, {isotropic(1.0, 0.3)}};
  problem.groups[0].loads[0].tractions = {{1, Vector{1.0, 0.0, 0.0}}, {0, Vector{-1.0, 0.0, 0.0}}};
  EXPECT_LT(solve(mesh, problem).loads[0].borne_by_places, 1e-6);
  problem.groups[0].loads[0].tractions.pop_back();
  EXPECT_GT(solve(mesh, problem).loads[0].borne_by_places, 0.1);
}

// No forces at all: what is borne and what it is compared with are rounding both.
TEST(FiniteElementSolve, PlacesThatMoveTheBodyBearNothing) {
  Problem problem = held({{Vector{1.0, 2.0, 3.0}, 0, 0.7},
                          {Vector{1.0, 2.0, 3.0}, 1, 0.3},
                          {Vector{1.0, 2.0, 3.0}, 2, 0.1},
                          {Vector{3.0, 2.0, 3.0}, 1, 0.3},
                          {Vector{3.0, 2.0, 3.0}, 2, 0.1},
                          {Vector{1.0, 3.0, 3.0}, 2, 0.1}});
  EXPECT_EQ(solve(block_mesh(kBlock, 0.5), problem).loads[0].borne_by_places, 0.0);
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
