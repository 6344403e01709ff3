// SPDX-License-Identifier: GPL-3.0-or-later
// The patch test: cells that fill a body exactly, with the stiffnesses of their lattice, deform as the body does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <nodal/elastic/stiffness.h>

#include "../../../support/messages.h"
#include "../plate.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

struct Patch {
  const char* name;
  std::string body;
  double spacing;
  std::string layout = "triangular";
  const char* topology = "triangular";
  std::size_t inner = 0, border = 0;  // springs, counted by hand

  friend void PrintTo(const Patch& patch, std::ostream* out) { *out << patch.name; }
};

std::shared_ptr<const ElasticProblem> make_patch(const Patch& patch, const std::string& material,
                                                 const std::string& initial = "lattice") {
  return as_elastic(parse_study(
      fmt::format("[study]\nname = \"patch\"\n[problem]\nkind = \"elastic\"\nbody = {{ {}, thickness = 0.02 }}\n"
                  "material = {{ young = 70e9, {} }}\npoints = {{ layout = \"{}\", spacing = {} }}\n"
                  "springs = {{ topology = \"{}\", initial = \"{}\" }}\n"
                  "loads = {{ stress = 1e6, supports = \"minimal\" }}\n",
                  patch.body, material, patch.layout, patch.spacing, patch.topology, initial),
      "patch.toml", components()));
}

const char* const kMaterials[] = {"poisson = 0.33333333333333333", "poisson = 0.25, plane = \"strain\""};

class PatchTest : public testing::TestWithParam<Patch> {
 protected:
  void SetUp() override {
    if (GetParam().topology == std::string("delaunay") && !triangulation_available()) GTEST_SKIP() << "needs CGAL";
  }
};

// A perfect fit but for rounding: 1e-10 is required, and some 1e-15 times the few hundred terms of a sum is there.
TEST_P(PatchTest, LatticeStiffnessIsExact) {
  for (const char* material : kMaterials) {
    SCOPED_TRACE(material);
    const auto problem = make_patch(GetParam(), material);
    const State state = problem->solve(problem->scene().initial_stiffness);
    ASSERT_EQ(state.status, Status::ok);
    EXPECT_LT(state.relative_error, 1e-12);
    // No other uniform factor would be: it is the stiffness that is right, not only its pattern.
    std::vector<double> softer = problem->scene().initial_stiffness;
    for (double& k : softer) k *= 0.99;
    EXPECT_NEAR(problem->solve(softer).relative_error, 0.01 / 0.99, 1e-6);
  }
}

// The rule against the number in the books, spring by spring.
TEST_P(PatchTest, SpringsInsideAreTwiceAsStiffAsThoseOnTheOutline) {
  if (GetParam().layout != "triangular") return;
  for (const char* material : kMaterials) {
    const auto problem = make_patch(GetParam(), material);
    const double young = 70e9 / (problem->scene().material.base.plane == Plane::strain ? 1.0 - 0.25 * 0.25 : 1.0);
    const double whole = 0.5 * std::numbers::sqrt3 * young * 0.02;
    std::size_t inner = 0, border = 0;
    for (const double k : problem->scene().initial_stiffness) {
      const bool on_outline = k < 0.75 * whole;
      (on_outline ? border : inner) += 1;
      EXPECT_NEAR(k, on_outline ? 0.5 * whole : whole, 1e-14 * whole);
    }
    EXPECT_EQ(inner, GetParam().inner);
    EXPECT_EQ(border, GetParam().border);
  }
}

// A hexagon of m cells per side has 3 m (3 m + 1) springs, 6 m of them on its outline; a triangle 3 m (m + 1) / 2 and
// 3 m. Odd m needs the grid's even rows shifted.
INSTANTIATE_TEST_SUITE_P(
    Bodies, PatchTest,
    testing::Values(
        Patch{.name = "hexagon4",
              .body = "shape = \"regular\", sides = 6, radius = 1.0",
              .spacing = 0.25,
              .inner = 156 - 24,
              .border = 24},
        Patch{.name = "hexagon3",
              .body = "shape = \"regular\", sides = 6, radius = 0.3, centre = [5.0, -2.0]",
              .spacing = 0.1,
              .inner = 90 - 18,
              .border = 18},
        Patch{.name = "hexagon1",
              .body = "shape = \"regular\", sides = 6, radius = 1.0",
              .spacing = 1.0,
              .inner = 6,
              .border = 6},
        Patch{.name = "triangle6",
              .body = "shape = \"regular\", sides = 3, radius = 2.0, turn = 90",
              .spacing = 2.0 * std::numbers::sqrt3 / 6.0,
              .inner = 63 - 18,
              .border = 18},
        Patch{.name = "tip_down5",
              .body = "shape = \"regular\", sides = 3, radius = 2.0, turn = -90",
              .spacing = 2.0 * std::numbers::sqrt3 / 5.0,
              .inner = 45 - 15,
              .border = 15},
        // The same by any triangulation: its triangles are the grid's.
        Patch{.name = "delaunay",
              .body = "shape = \"regular\", sides = 6, radius = 1.0",
              .spacing = 1.0 / 3.0,
              .topology = "delaunay",
              .inner = 90 - 18,
              .border = 18},
        // Crossed squares, with a corner cut out and a hole.
        Patch{.name = "ell",
              .body = "outline = [[0, 0], [3, 0], [3, 2], [2, 2], [2, 3], [0, 3]]",
              .spacing = 0.5,
              .layout = "grid",
              .topology = "crossed"},
        Patch{.name = "frame",
              .body = "outline = [[0, 0], [4, 0], [4, 4], [0, 4]], holes = [[[1, 1], [2, 1], [2, 2], [1, 2]]]",
              .spacing = 1.0,
              .layout = "grid",
              .topology = "crossed"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(LatticeStart, IsTheAreaRuleOnTrianglesInPlaneStress) {
  const Patch hexagon{.name = "hexagon", .body = "shape = \"regular\", sides = 6, radius = 1.0", .spacing = 0.25};
  const auto lattice = make_patch(hexagon, kMaterials[0]), area = make_patch(hexagon, kMaterials[0], "area");
  for (std::size_t e = 0; e < lattice->net().springs.size(); ++e)
    EXPECT_NEAR(area->scene().initial_stiffness[e], lattice->scene().initial_stiffness[e],
                1e-13 * lattice->scene().initial_stiffness[e]);
}

// Where cells don't reach the outline, the net is another body.
TEST(LatticeStart, IsRefusedWhereCellsDontFillTheBody) {
  const char* refusal =
      "patch.toml:8: the 'lattice' rule needs a crossed grid of square cells, or equilateral triangles, that fill the "
      "body to its outline; take springs = { initial = \"area\" }";
  const Patch refused[] = {
      {.name = "a rectangle's sides are ragged", .body = "size = [4.0, 1.7320508075688772]", .spacing = 1.0},
      {.name = "an ell's cut corner lies within cells",
       .body = "outline = [[0, 0], [3, 0], [3, 2], [2, 2], [2, 3], [0, 3]]",
       .spacing = 0.75,
       .layout = "grid",
       .topology = "crossed"},
      {.name = "no diagonals to cross",
       .body = "size = [4.0, 4.0]",
       .spacing = 1.0,
       .layout = "grid",
       .topology = "single"},
  };
  for (const Patch& patch : refused)
    EXPECT_EQ(toy::message_of([&] { (void)make_patch(patch, kMaterials[0]); }), refusal) << patch.name;
}

}  // namespace
}  // namespace nodal::elastic
