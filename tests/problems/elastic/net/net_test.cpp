// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../plate.h"

namespace nodal::elastic {
namespace {

TEST(Grid, IsNumberedRowByRowFromTheLowerLeft) {
  const Net net = make_grid_net(plane::rectangle_body({1.0, 2.0}, {3.0, 1.0}), 4, 3, "crossed");
  ASSERT_EQ(net.nodes.size(), 12u);
  EXPECT_EQ(net.nodes[0], (Vector{1.0, 2.0}));
  EXPECT_EQ(net.nodes[3], (Vector{4.0, 2.0}));
  EXPECT_EQ(net.nodes[4], (Vector{1.0, 2.5}));
  EXPECT_EQ(net.nodes[11], (Vector{4.0, 3.0}));
}

// Axial springs: (c−1)r + c(r−1); one or two diagonals per cell.
TEST(Grid, HasAsManySpringsAsItsTopologySays) {
  const Body square = plane::rectangle_body({0, 0}, {4, 4});
  EXPECT_EQ(make_grid_net(square, 5, 5, "crossed").springs.size(), 72u);
  EXPECT_EQ(make_grid_net(square, 5, 5, "single").springs.size(), 56u);
  EXPECT_EQ(make_grid_net(square, 5, 5, "alternating").springs.size(), 56u);
}

TEST(Grid, ListsEverySpringOnceByAscendingNodes) {
  const Net net = make_grid_net(plane::rectangle_body({0, 0}, {2, 1}), 6, 4, "crossed");
  std::set<std::pair<std::size_t, std::size_t>> seen;
  std::pair<std::size_t, std::size_t> last = {0, 0};
  for (const Spring& s : net.springs) {
    EXPECT_LT(s.first, s.second);
    EXPECT_TRUE(seen.insert({s.first, s.second}).second);
    EXPECT_LT(last, (std::pair{s.first, s.second}));
    last = {s.first, s.second};
    EXPECT_NEAR(std::hypot(s.direction[0], s.direction[1]), 1.0, 1e-15);
  }
}

TEST(Grid, KnowsBorderAndCorners) {
  const Net net = make_grid_net(plane::rectangle_body({0, 0}, {4, 4}), 5, 5, "crossed");
  int border = 0, corners = 0;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    border += net.on_border(i);
    corners += net.on_corner(i);
  }
  EXPECT_EQ(border, 16);
  EXPECT_EQ(corners, 4);
}

std::size_t coordinates(const char* rule, const char* topology = "crossed", std::size_t columns = 5,
                        std::size_t rows = 5, plane::Point size = {4, 4}) {
  return Parameters(make_grid_net(plane::rectangle_body({0, 0}, size), columns, rows, topology), rule).size();
}

// A crossed 5 × 5 square: under the square's eight symmetries the 40 axial springs fall into 6 classes (by orbits of 8
// and 4: 40 = 8·4 + 4·2), the 32 diagonals into 6 (32 = 8·2 + 4·4).
TEST(Parameters, TieWhatTheirRuleSays) {
  EXPECT_EQ(coordinates("each"), 72u);
  EXPECT_EQ(coordinates("by-direction"), 3u);
  EXPECT_EQ(coordinates("uniform"), 1u);
  EXPECT_EQ(coordinates("symmetric"), 12u);
}

TEST(Parameters, TieMirrorImagesOnly) {
  const Net net = make_grid_net(plane::rectangle_body({0, 0}, {4, 4}), 5, 5, "crossed");
  const Parameters parameters(net, "symmetric");
  const auto middle = [&](std::size_t e) {
    const Spring& s = net.springs[e];
    const double x = std::abs(0.5 * (net.nodes[s.first][0] + net.nodes[s.second][0]) - 2.0);
    const double y = std::abs(0.5 * (net.nodes[s.first][1] + net.nodes[s.second][1]) - 2.0);
    return std::minmax({x, y});
  };
  for (std::size_t g = 0; g < parameters.size(); ++g) {
    const auto members = parameters.springs_of(g);
    for (const std::size_t e : members) {
      EXPECT_NEAR(net.springs[e].length, net.springs[members[0]].length, 1e-14);
      EXPECT_NEAR(middle(e).first, middle(members[0]).first, 1e-12);
      EXPECT_NEAR(middle(e).second, middle(members[0]).second, 1e-12);
    }
  }
}

// One diagonal per cell lacks the plate's two reflections, but has the half turn and both diagonal reflections. Of 56
// springs the half turn keeps none in place, each reflection 4 (those along the one diagonal, or across the other):
// (56 + 0 + 4 + 4)/4 = 16 classes (Burnside).
TEST(Parameters, TakeTheSymmetriesThatATopologyHas) {
  EXPECT_EQ(coordinates("symmetric", "single"), 16u);
  EXPECT_NO_THROW(coordinates("symmetric", "crossed", 4, 3, {3, 1}));
}

TEST(Parameters, StartTiedGroupsAtTheGeometricMean) {
  const Net net = make_grid_net(plane::rectangle_body({0, 0}, {1, 1}), 2, 2, "crossed");
  const Parameters parameters(net, "uniform");
  std::vector<double> k = {1, 2, 4, 8, 16, 32}, x(1), tied(6);
  parameters.coordinates(k, x);
  parameters.stiffness(x, tied);
  for (const double t : tied) EXPECT_NEAR(t, std::pow(2.0, 2.5), 1e-14);
}

// ── what a study may not ask for
// ───────────────────────────────────────────────────────────────────────────────────────

std::string refusal(const PlateOptions& options) {
  try {
    make_plate(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Scene, RefusesAGridTopologyAsAMechanism) {
  EXPECT_EQ(refusal({.topology = "grid"}),
            "plate.toml:8: topology 'grid' is a mechanism: no diagonals, so its cells shear without resistance; take "
            "springs = { topology = \"crossed\" }, or \"single\" or \"alternating\"");
}
TEST(Scene, OffersTheNearestTopology) {
  EXPECT_EQ(refusal({.topology = "crosed"}), "plate.toml:8: unknown topology 'crosed'; did you mean 'crossed'?");
}
TEST(Scene, RefusesOneRowGrids) {
  EXPECT_EQ(
      refusal({.counts = "[5, 1]"}),
      "plate.toml:7: 'counts' is [5, 1]: a grid with one row or column has no area; give at least 2 nodes in each "
      "direction");
}
TEST(Scene, TakesTheSymmetriesThatATopologyHas) {
  EXPECT_EQ(refusal({.parameters = "symmetric", .topology = "single"}), "accepted");
}
TEST(Scene, RefusesBoundsInTheWrongOrder) {
  EXPECT_EQ(refusal({.bounds = "[10.0, 1.0]"}),
            "plate.toml:8: 'bounds' is [10, 1]; it must be [lower, upper] with 0 < lower < upper");
}
TEST(Scene, RefusesAZeroStress) {
  EXPECT_EQ(refusal({.stress = 0.0}),
            "plate.toml:9: 'stress' is 0: the reference displacement is zero everywhere, so there is nothing to fit");
}
TEST(Scene, RefusesIncompressiblePlaneStrain) {
  EXPECT_EQ(
      refusal({.poisson = 0.49995, .plane = "strain"}),
      "plate.toml:6: 'poisson' is 0.49995: in plane strain a body this incompressible can't be computed with; it must "
      "be ≤ 0.4999");
}

// ── what explain says, and what a scene costs
// ──────────────────────────────────────────────────────────────────────────

TEST(Stages, AreLeftOutWhereTheSceneDoesNotNeedThem) {
  std::size_t used = 0, left_out = 0;
  for (const Stage& stage : make_plate()->stages()) ++(stage.used ? used : left_out);
  EXPECT_EQ(used, 14u);
  EXPECT_EQ(left_out, 7u);  // Voronoi regions, triangulation, rigidity, masses, elements, measurements, prior
}

TEST(Stages, FactorizeOncePerSupportGroup) {
  for (const auto& [supports, groups] : {std::pair{"edge", 4}, std::pair{"minimal", 1}}) {
    const auto plate = make_plate({.supports = supports});
    const auto evaluator = plate->make_evaluator();
    ASSERT_TRUE(evaluator->value(plate->space().start()).ok());
    EXPECT_EQ(evaluator->work().factorizations, groups);
  }
}

}  // namespace
}  // namespace nodal::elastic
