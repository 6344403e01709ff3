// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of polygons with holes: what they fill, how they are graded, and that they end.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include <nodal/error.h>

#include "finite_elements/locator.h"
#include "finite_elements/plane_mesh.h"
#include "finite_elements/size_field.h"

namespace nodal::elastic::finite_elements {
namespace {

// The square [0, 4]² with the hole [1, 2]²; x < 3 is region 0.
PlaneBody frame() {
  PlaneBody body;
  body.rings = {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0, 1, 2, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {4, 5, 6, 7}}};
  body.interfaces = {{{3, -1}, {3, 5}}};
  body.region = [](const Vector& x) -> std::size_t { return x[0] < 3.0 ? 0 : 1; };
  return body;
}

double area_of(const Mesh& mesh, std::size_t region) {
  double area = 0.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region[c] == region) area += measure(mesh, c);
  return area;
}

double edge(const Mesh& mesh, std::size_t c, std::size_t k) {
  return distance(mesh.nodes[mesh.cell(c)[k]], mesh.nodes[mesh.cell(c)[(k + 1) % 3]]);
}

double longest_edge(const Mesh& mesh, std::size_t c) {
  return std::max({edge(mesh, c, 0), edge(mesh, c, 1), edge(mesh, c, 2)});
}

double smallest_angle(const Mesh& mesh) {
  double sine = 1.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t k = 0; k < 3; ++k)
      sine = std::min(sine, 2.0 * measure(mesh, c) / (edge(mesh, c, k) * edge(mesh, c, (k + 1) % 3)));
  return std::asin(sine);
}

double length_of(const Mesh& mesh, std::size_t label) {
  double length = 0.0;
  for (std::size_t s = 0; s < mesh.side_count(); ++s)
    if (mesh.side_label[s] == label) length += distance(mesh.nodes[mesh.side(s)[0]], mesh.nodes[mesh.side(s)[1]]);
  return length;
}

TEST(PlaneMesh, FillsTheBodyAndKnowsItsSides) {
  const Mesh mesh = plane_mesh(frame(), 0.5);
  EXPECT_NEAR(area_of(mesh, 0), 11.0, 1e-12);
  EXPECT_NEAR(area_of(mesh, 1), 4.0, 1e-12);
  for (std::size_t label = 0; label < 8; ++label) EXPECT_NEAR(length_of(mesh, label), label < 4 ? 4.0 : 1.0, 1e-12);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) EXPECT_LE(longest_edge(mesh, c), 0.5);
  EXPECT_GT(smallest_angle(mesh), 20.6 / 180.0 * 3.14159);
}

TEST(PlaneMesh, IsTheSameAgain) {
  const Mesh first = plane_mesh(frame(), 0.3), second = plane_mesh(frame(), 0.3);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.cells, second.cells);
  EXPECT_EQ(first.sides, second.sides);
}

TEST(PlaneMesh, IsFineAtGradedPlacesAlone) {
  PlaneBody body = frame();
  body.graded = {{0, 0}};
  const Mesh mesh = plane_mesh(body, 0.5);
  double smallest = 1.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    Vector centre{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 2; ++axis) centre[axis] += mesh.nodes[mesh.cell(c)[k]][axis] / 3.0;
    EXPECT_LE(longest_edge(mesh, c), 0.5 * std::min(1.0, std::pow(norm(centre), 0.7)) * (1.0 + 1e-12));
    smallest = std::min(smallest, longest_edge(mesh, c));
  }
  EXPECT_LT(smallest, 0.15);  // (0.5/1)^{1/0.3} = 0.1 is what the law asks for
  EXPECT_LT(mesh.cell_count(), 4 * plane_mesh(frame(), 0.5).cell_count());
}

// λ as tables print it, and slightly more than half a turn by its series, λ = 1 − 2δ/π.
TEST(PlaneMesh, CornersThatTurnInwardsAreGradedByTheirAngle) {
  const double half = std::numbers::pi;
  EXPECT_NEAR(corner_exponent(1.5 * half), 0.544483736782464, 1e-12);
  EXPECT_NEAR(corner_exponent(2.0 * half), 0.5, 1e-9);
  EXPECT_NEAR(corner_exponent(half + 0.01), 1.0 - 0.02 / half, 1e-4);
  EXPECT_EQ(corner_exponent(half), 1.0);
  SizeField size(0.1, 1.0);
  size.grade_corners({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}});  // 270° at (2, 2) alone
  EXPECT_DOUBLE_EQ(size.at(0.0, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(size.at(2.0, 1.5), 0.1 * std::pow(0.5, 0.8));  // 1 − 2λ/5 = 0.782
}

TEST(PlaneMesh, HasTheVerticesThatAreAskedFor) {
  PlaneBody body = frame();
  body.vertices = {{2.5, 2.71}};
  const Mesh mesh = plane_mesh(body, 1.0);
  EXPECT_NE(std::ranges::find(mesh.nodes, Vector{2.5, 2.71, 0.0}), mesh.nodes.end());
}

TEST(PlaneMesh, NeedlesEnd) {
  PlaneBody body;
  body.rings = {{{{0, 0}, {10, 0}, {10, 0.05}}, {0, 1, 2}}};  // 0.3 degrees
  const Mesh mesh = plane_mesh(body, 1.0);
  EXPECT_NEAR(area_of(mesh, 0), 0.25, 1e-12);
  EXPECT_LT(mesh.cell_count(), 20000u);
  body.interfaces = {{{0, 0}, {10, 0.01}}, {{0, 0}, {10, 0.02}}, {{5, -1}, {5.001, 1}}};
  EXPECT_NEAR(area_of(plane_mesh(body, 1.0), 0), 0.25, 1e-12);
}

// A triangle's centre may come to lie where it is graded.
TEST(PlaneMesh, GradedPlacesThatAreNoVerticesEnd) {
  PlaneBody body = frame();
  body.graded = {{1e-12, 1e-12}, {3.3, 2.1}, {0.5, 0.5}, {2.0, 1e-9}, {-1.0, 1.0}, {4.0 / 3.0, 3.0}};
  for (const double spacing : {0.3, 0.5, 0.8}) {
    const Mesh mesh = plane_mesh(body, spacing);
    EXPECT_NEAR(area_of(mesh, 0) + area_of(mesh, 1), 15.0, 1e-12);
    EXPECT_LT(mesh.cell_count(), 30000u);
  }
}

TEST(PlaneMesh, InterfacesAlongSidesAndBeyondThemEnd) {
  PlaneBody body = frame();
  body.interfaces = {
      {{0.5, 1e-9}, {9.0, -1e-9}}, {{3, 0}, {3, 4}}, {{3, 1}, {3, 3.5}}, {{1, 1.2}, {1, 1.8}}, {{2, 2}, {4, 4}}};
  const Mesh mesh = plane_mesh(body, 0.5);
  EXPECT_NEAR(area_of(mesh, 0) + area_of(mesh, 1), 15.0, 1e-12);
  EXPECT_LT(mesh.cell_count(), 2000u);
}

TEST(PlaneMesh, TooManyTrianglesAreRefusedWithWhere) {
  PlaneBody body = frame();
  body.cell_limit = 300;
  body.graded = {{4, 0}};
  try {
    (void)plane_mesh(body, 0.1);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("more than 300 triangles"), std::string::npos) << refusal.what();
  }
}

TEST(PlaneMesh, RefinedTwiceItFindsPlacesByDescending) {
  const Mesh coarse = plane_mesh(frame(), 1.0), middle = refined(coarse), fine = refined(middle);
  EXPECT_NEAR(area_of(fine, 1), 4.0, 1e-12);
  EXPECT_NEAR(length_of(fine, 6), 1.0, 1e-12);
  const Locator locator(coarse);
  for (double x = 0.0; x <= 4.0; x += 0.125)
    for (double y = 0.0; y <= 4.0; y += 0.125) {
      if (x > 1.0 && x < 2.0 && y > 1.0 && y < 2.0) continue;
      const Vector place = {x, y, 0.0};
      const Location found = descended(fine, descended(middle, locator.locate(place), place), place);
      EXPECT_LT(Locator::distance(fine, found), 1e-12) << x << " " << y;
    }
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
