// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that textbooks and benchmarks print: stresses at holes, displacements of rings.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "bodies.h"
#include "fields.h"
#include "finite_elements/solution.h"
#include "finite_elements/stress.h"

namespace nodal::elastic::finite_elements {
namespace {

Tensor stress_in(const Mesh& mesh, const Problem& problem, const Vector& place) {
  const Solution solution = solve(mesh, problem);
  const NodalStress stress = nodal_stress(mesh, problem.regions, solution.loads[0].displacement);
  return stress_at(mesh, stress, Locator(mesh).locate(place));
}

// A hole of 512 sides, free, in a square that is pulled as the infinite plate is there.
TEST(OutsideFigures, KirschsHoleThreefoldsTheStress) {
  PlaneBody body;
  body.rings = {rectangle(-4, -4, 4, 4), circle(1.0, 512, 4, true)};
  const Mesh mesh = plane_mesh(body, 0.5);
  const Field field = hole_field(1.0, 0.3, 1.0);
  const Problem problem = pulled_as(field, {isotropic(1.0, 0.3)}, 2, {0, 1, 2, 3}, {{-4, -4, 0}, {4, -4, 0}});
  const double apothem = std::cos(std::numbers::pi / 512.0);
  const double top = stress_in(mesh, problem, {0.0, apothem, 0.0})[0][0];
  EXPECT_NEAR(top, 3.0, 0.06);
  EXPECT_NEAR(stress_in(mesh, problem, {apothem, 0.0, 0.0})[1][1], -1.0, 0.06);
}

// Held at two places of its border that bear nothing, so all radial displacement is relative to those.
TEST(OutsideFigures, LamesRingWidens) {
  PlaneBody body;
  body.rings = {circle(2.0, 512, 0, false), circle(1.0, 512, 1, true)};
  body.vertices = {{1.5, 0.0}, {-1.5, 0.0}, {0.0, 1.5}};
  const Mesh mesh = plane_mesh(body, 0.3);
  Problem problem{{{isotropic(2.0, 0.3)}}, {{}}};
  problem.groups[0].prescribed = {{Vector{1.5, 0, 0}, 1}, {Vector{-1.5, 0, 0}, 1}, {Vector{0, 1.5, 0}, 0}};
  problem.groups[0].loads = {{{{1, StressField{tensor(-1, -1, 0)}}}}};
  const Solution solution = solve(mesh, problem);
  EXPECT_LT(solution.loads[0].borne_by_places, 1e-9);
  const Locator locator(mesh);
  const Field field = ring_field(2.0, 0.3, 1.0, 2.0, 1.0);
  for (const double r : {1.0, 1.25, 1.5, 2.0})
    for (const double angle : {0.3, 1.9, 4.0}) {
      const Vector x = {r * std::cos(angle), r * std::sin(angle), 0.0};
      const Vector u = interpolated(mesh, locator.locate(x), solution.loads[0].displacement);
      EXPECT_NEAR(dot(u, x) / r, norm(field.displacement(x)), 1e-3 * norm(field.displacement(x))) << r;
    }
}

// NAFEMS LE1, N/mm² and m: a quarter of a plate between two ellipses, 10 pulling at the outer one.
TEST(OutsideFigures, EllipticMembrane) {
  const double half = 0.5 * std::numbers::pi, step = half / 128.0;
  PlaneBody body;
  LabelledRing ring;
  const auto append = [&](const plane::Ring& points, std::size_t label) {
    for (const plane::Point& p : points) ring.points.push_back(p), ring.labels.push_back(label);
  };
  // Arcs begin and end in the middle of a side, as if their mirror images continued them.
  append({{2.0 * std::cos(0.5 * step), 0.0}}, 0);
  append({{3.25 * std::cos(0.5 * step), 0.0}}, 1);
  append(arc(3.25, 2.75, 0.5 * step, half - 0.5 * step, 128), 1);
  append({{0.0, 2.75 * std::cos(0.5 * step)}}, 2);
  append({{0.0, std::cos(0.5 * step)}}, 3);
  append(arc(2.0, 1.0, half - 0.5 * step, 0.5 * step, 128), 3);
  body.rings = {ring};
  Problem problem{{{isotropic(210e3, 0.3)}}, {{}}};
  problem.groups[0].prescribed = {{std::size_t{0}, 1}, {std::size_t{2}, 0}};
  problem.groups[0].loads = {{{{1, StressField{tensor(10, 10, 0)}}}}};
  const double stress = stress_in(plane_mesh(body, 0.1), problem, {2.0, 0.0, 0.0})[1][1];
  RecordProperty("stress", fmt::format("{:.3f}", stress));
  EXPECT_NEAR(stress, 92.7, 0.02 * 92.7);
  EXPECT_NEAR(stress, 91.7, 0.1);  // what the page says; of an ellipse of 2,048 sides it is 92.4
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
