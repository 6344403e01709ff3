// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include <nodal/elastic/net.h>
#include <nodal/error.h>

#include "../bodies.h"
#include "geometry/plane/segment.h"
#include "points/grid_points.h"
#include "points/random_points.h"

namespace nodal::elastic::plane {
namespace {

std::size_t count(const PlacedPoints& points, NodeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(points.places.begin(), points.places.end(), [kind](const Placement& p) { return p.kind == kind; }));
}

// What every way of placing promises: in the body, and places that say where.
void expect_placed(const Outline& outline, const PlacedPoints& placed) {
  ASSERT_EQ(placed.points.size(), placed.places.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_TRUE(outline.contains(placed.points[i]));
    const Placement& place = placed.places[i];
    if (place.kind == NodeKind::inner) {
      EXPECT_GT(outline.distance(placed.points[i]), outline.tolerance());
      continue;
    }
    const Chain& chain = outline.chains()[place.chain];
    EXPECT_LE(distance(outline.at(chain.ring, place.arc), placed.points[i]), outline.tolerance());
    EXPECT_EQ(place.kind == NodeKind::corner, !chain.closed && place.arc == chain.begin);
  }
}

TEST(ExactGrid, OfARectangleIsTheGridNet) {
  const Body body = rectangle_body({1, 2}, {3, 2});
  const Outline outline(body);
  for (const char* topology : {"single", "alternating", "crossed"}) {
    const Net net = make_grid_net(body, 7, 5, topology);
    const GridPoints grid = make_exact_grid(outline, {0.5, 0.5}, GridCells::rectangular);
    ASSERT_EQ(lifted(grid.points.points), net.nodes);
    for (std::size_t i = 0; i < net.nodes.size(); ++i) EXPECT_EQ(grid.points.places[i].kind, net.kinds[i]);
    const auto springs = join_grid(outline, grid, topology);
    ASSERT_EQ(springs.size(), net.springs.size());
    for (std::size_t e = 0; e < springs.size(); ++e)
      EXPECT_EQ(springs[e], (std::array{net.springs[e].first, net.springs[e].second}));
  }
}

// 5 × 5 nodes; the hole [1, 2]² lies between four of them, which stay: its own cell is whole but for its diagonals.
TEST(ExactGrid, LeavesOutWhatLiesInAHole) {
  const Outline outline(frame());
  const GridPoints grid = make_exact_grid(outline, {1, 1}, GridCells::rectangular);
  EXPECT_EQ(grid.points.size(), 25u);
  EXPECT_EQ(count(grid.points, NodeKind::corner), 8u);
  EXPECT_EQ(join_grid(outline, grid, "crossed").size(), 72u - 2u);
  EXPECT_EQ(join_grid(outline, grid, "grid").size(), 40u);

  const GridPoints fine = make_exact_grid(outline, {0.5, 0.5}, GridCells::rectangular);
  EXPECT_EQ(fine.points.size(), 81u - 1u);  // the hole's middle
  // The middle's 4 axial and 4 diagonal springs, and in each of the hole's 4 cells the other diagonal.
  EXPECT_EQ(join_grid(outline, fine, "crossed").size(), 9u * 8u * 2u + 2u * 64u - 4u - 4u - 4u);
}

TEST(ExactGrid, OfAnEllHasNoSpringsThroughTheCutAwayCorner) {
  const Outline outline(ell());
  const GridPoints grid = make_exact_grid(outline, {1, 1}, GridCells::rectangular);
  EXPECT_EQ(grid.points.size(), 15u);
  // 8 cells of 2 diagonals; axial: 12 along rows 0 to 2 less none missing (3 each), 2 in row 3; the same in columns.
  EXPECT_EQ(join_grid(outline, grid, "crossed").size(), 16u + 2u * (3u * 3u + 2u));
  EXPECT_EQ(join_grid(outline, grid, "single").size(), 8u + 22u);
}

TEST(ExactGrid, MeetsTheFarBorderInSpiteOfRounding) {
  EXPECT_EQ(
      make_exact_grid(Outline(rectangle_body({0, 0}, {1, 0.3})), {0.1, 0.1}, GridCells::rectangular).points.size(),
      44u);
  EXPECT_EQ(make_exact_grid(Outline(rectangle_body({0.1, 0.1}, {0.7, 0.7})), {0.1, 0.1}, GridCells::rectangular)
                .points.size(),
            64u);
}

// Rows of 5, 4, 5 nodes, height √3: all three directions, every triangle equilateral.
TEST(ExactGrid, OfTrianglesJoinsThreeDirections) {
  const Outline outline(rectangle_body({0, 0}, {4, std::numbers::sqrt3}));
  const GridPoints grid = make_exact_grid(outline, {1, 0}, GridCells::triangular);
  EXPECT_EQ(grid.points.size(), 14u);
  const auto springs = join_grid(outline, grid, "triangular");
  EXPECT_EQ(springs.size(), 4u + 3u + 4u + 8u + 8u);
  std::set<std::array<std::size_t, 2>> seen;
  for (const auto& [i, j] : springs) {
    EXPECT_LT(i, j);
    EXPECT_TRUE(seen.insert({i, j}).second);
    EXPECT_NEAR(distance(grid.points.points[i], grid.points.points[j]), 1.0, 1e-15);
  }
}

// Both ways to shift every other row are tried: a hexagon with an odd number of cells per side needs its lowest row
// shifted, or no row but the middle ones' ends would meet the outline.
TEST(ExactGrid, OfTrianglesMeetsAHexagonOfAnyNumberOfCells) {
  for (const std::size_t m : {1u, 2u, 3u, 4u, 7u}) {
    SCOPED_TRACE(m);
    const Outline outline(regular_body({1, 2}, 3.0, 6));
    const GridPoints grid = make_exact_grid(outline, {3.0 / static_cast<double>(m), 0}, GridCells::triangular);
    EXPECT_EQ(grid.even_rows_shifted, m % 2 == 1);
    EXPECT_EQ(grid.points.size(), 3 * m * (m + 1) + 1);
    EXPECT_EQ(count(grid.points, NodeKind::corner), 6u);
    EXPECT_EQ(count(grid.points, NodeKind::border), 6 * (m - 1));
    const auto springs = join_grid(outline, grid, "triangular");
    EXPECT_EQ(springs.size(), 3 * m * (3 * m + 1));
    const std::vector<Triangle> triangles = grid_triangles(outline, grid, springs);
    EXPECT_EQ(triangles.size(), 6 * m * m);
    double area = 0.0;
    for (const auto& [a, b, c] : triangles) {
      const std::vector<Point>& at = grid.points.points;
      const double twice =
          (at[b][0] - at[a][0]) * (at[c][1] - at[a][1]) - (at[b][1] - at[a][1]) * (at[c][0] - at[a][0]);
      EXPECT_GT(twice, 0.0);
      area += 0.5 * twice;
    }
    EXPECT_NEAR(area, outline.area(), 1e-12 * area);
  }
}

// A hole of one triangle lies between three springs.
TEST(ExactGrid, OfTrianglesHasNoTriangleInAHole) {
  const double height = std::numbers::sqrt3 / 2.0;
  Body body = regular_body({0, 0}, 3.0, 6);
  body.rings.push_back({{0, 0}, {0.5, height}, {1, 0}});
  const Outline outline(body);
  const GridPoints grid = make_exact_grid(outline, {1, 0}, GridCells::triangular);
  const auto springs = join_grid(outline, grid, "triangular");
  EXPECT_EQ(springs.size(), 90u);
  EXPECT_EQ(grid_triangles(outline, grid, springs).size(), 53u);
}

TEST(ExactGrid, RefusesWhatCantBe) {
  const Outline outline(ell());
  EXPECT_THROW((void)make_exact_grid(outline, {0, 1}, GridCells::rectangular), Refusal);
  EXPECT_THROW((void)make_exact_grid(outline, {1e-6, 1e-6}, GridCells::rectangular), Refusal);
  const GridPoints grid = make_exact_grid(outline, {1, 1}, GridCells::rectangular);
  EXPECT_THROW((void)join_grid(outline, grid, "triangular"), Refusal);
  EXPECT_THROW((void)join_grid(outline, grid, "round"), Refusal);
}

TEST(FittedGrid, FollowsTheOutline) {
  RandomStream random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Outline outline(random_star(random));
    const double h = random.uniform(0.05, 0.3);
    for (const GridCells cells : {GridCells::rectangular, GridCells::triangular}) {
      const PlacedPoints fitted = make_fitted_grid(outline, {h, h}, cells);
      expect_placed(outline, fitted);
      std::size_t corners = 0;
      for (std::size_t r = 0; r < outline.rings(); ++r) corners += outline.corners(r);
      EXPECT_EQ(count(fitted, NodeKind::corner), corners);
      for (std::size_t i = 0; i < fitted.size(); ++i)
        if (fitted.places[i].kind == NodeKind::inner) {
          EXPECT_GE(outline.distance(fitted.points[i]), 0.49999 * h);
        }
    }
  }
}

TEST(FittedGrid, OfARectangleThatHoldsWholeCellsIsTheGrid) {
  const Outline outline(rectangle_body({0, 0}, {4, 3}));
  const PlacedPoints fitted = make_fitted_grid(outline, {0.5, 1}, GridCells::rectangular);
  EXPECT_EQ(fitted.size(), 9u * 4u);
  EXPECT_EQ(count(fitted, NodeKind::border), 2u * 7u + 2u * 2u);
}

TEST(RandomPoints, AreAsManyAsAskedForAndTheSameForTheSameSeed) {
  RandomStream bodies(11);
  for (int trial = 0; trial < 50; ++trial) {
    const Outline outline(random_star(bodies));
    for (const BorderSpread spread : {BorderSpread::evenly, BorderSpread::at_random}) {
      const RandomPointsOptions options = {.inner = 40, .border = least_border_points(outline) + 20, .spread = spread};
      RandomStream first(5), second(5);
      const PlacedPoints points = make_random_points(outline, options, first);
      expect_placed(outline, points);
      EXPECT_EQ(count(points, NodeKind::inner), 40u);
      EXPECT_EQ(points.size(), 40u + options.border);
      const PlacedPoints again = make_random_points(outline, options, second);
      EXPECT_EQ(points.points, again.points);
      EXPECT_EQ(points.places, again.places);
    }
  }
}

// Shares of the quarters of a square agree with a binomial's deviation: 4σ of 10,000 draws at ¼ is 173.
TEST(RandomPoints, AreUniformInTheBody) {
  const Outline outline(ell());
  RandomStream random(2);
  const PlacedPoints points = make_random_points(outline, {.inner = 16000, .border = 6}, random);
  std::array<int, 9> in_square{};
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.places[i].kind == NodeKind::inner)
      ++in_square[static_cast<std::size_t>(points.points[i][0]) + 3 * static_cast<std::size_t>(points.points[i][1])];
  for (std::size_t s = 0; s < 8; ++s) EXPECT_NEAR(in_square[s], 2000, 4.0 * std::sqrt(2000.0 * 7.0 / 8.0));
  EXPECT_EQ(in_square[8], 0);
}

// In the unit square with ρ = 1 + 8 exp(−|x − c|²/r²) the share within r of the centre is
// (πr² + 8πr²(1 − 1/e)) / (1 + 8πr²).
TEST(RandomPoints, FollowADensity) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  RandomStream random(4);
  const double r = 0.1, disc = std::numbers::pi * r * r;
  const PlacedPoints points =
      make_random_points(outline, {.inner = 20000, .border = 4, .density = Density({{{0.5, 0.5}, r, 9.0}})}, random);
  const auto near = std::ranges::count_if(points.points, [&](const Point& p) { return distance(p, {0.5, 0.5}) < r; });
  const double share = (disc + 8.0 * disc * (1.0 - std::exp(-1.0))) / (1.0 + 8.0 * disc);
  EXPECT_NEAR(static_cast<double>(near) / 20000.0, share, 4.0 * std::sqrt(share * (1.0 - share) / 20000.0));
}

TEST(RandomPoints, SayHowManyTheOutlineNeeds) {
  const Outline outline(frame());
  EXPECT_EQ(least_border_points(outline), 8u);
  RandomStream random(1);
  try {
    (void)make_random_points(outline, {.inner = 5, .border = 7}, random);
    FAIL() << "7 border points for 8 corners";
  } catch (const Refusal& e) {
    EXPECT_NE(std::string(e.what()).find("8 in all"), std::string::npos) << e.what();
  }
  EXPECT_THROW((void)share_points(outline, 7), Refusal);
  EXPECT_EQ(least_border_points(Outline(ring_body({0, 0}, 2, 1, 60))), 6u);
}

// A square of side 1 and 400 points: h = √(2/(400 √3)) = 0.0537, 74 points on the border.
TEST(RandomPoints, AreSharedBetweenBorderAndInside) {
  const RandomPointsOptions shared = share_points(Outline(rectangle_body({0, 0}, {1, 1})), 400);
  EXPECT_EQ(shared.border, 74u);
  EXPECT_EQ(shared.inner, 326u);
}

TEST(RandomPoints, DoNotHangInSlenderBodies) {
  Body needle = {.name = "needle", .rings = {{{0, 0}, {1000, 1000}, {1000, 1000.001}, {0, 0.001}}}};
  const Outline outline(needle);
  RandomStream random(6);
  const PlacedPoints points = make_random_points(outline, {.inner = 1000, .border = 4}, random);
  EXPECT_EQ(points.size(), 1004u);
  expect_placed(outline, points);
}

TEST(RandomPoints, GiveUpADensityThatKeepsHardlyAnyDraw) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  RandomStream random(6);
  EXPECT_THROW((void)make_random_points(
                   outline, {.inner = 10, .border = 4, .density = Density({{{0.5, 0.5}, 1e-5, 1e9}})}, random),
               Refusal);
}

TEST(Density, RefusesSpotsThatTakeMoreThanThereIs) {
  EXPECT_THROW(Density({{{0, 0}, 1.0, 0.0}}), Refusal);
  EXPECT_THROW(Density({{{0, 0}, 0.0, 2.0}}), Refusal);
  EXPECT_NO_THROW(Density({{{0, 0}, 1.0, 0.4}, {{9, 0}, 1.0, 0.4}}));
  EXPECT_THROW(Density({{{0, 0}, 1.0, 0.4}, {{0.1, 0}, 1.0, 0.4}}), Refusal);
  // Each alone leaves something at either centre; between them there is nothing left.
  EXPECT_THROW(Density({{{0, 0}, 1.0, 0.35}, {{1.2, 0}, 1.0, 0.35}, {{0.6, 1.0}, 1.0, 0.35}}), Refusal);
}

// Against the closed form over a square of whole reach, and a fine midpoint rule over a triangle that crosses the spot.
TEST(Density, IntegratesSpotsOverPolygons) {
  const Density density({{{0.3, 0.2}, 0.25, 5.0}});
  const auto integrate = [&](const Ring& ring, const Point& node) {
    WeightedSums sums;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      density.add_edge(node, {a[0] - node[0], a[1] - node[1]}, {b[0] - node[0], b[1] - node[1]}, sums);
    }
    return sums;
  };
  const double whole = 4.0 * std::numbers::pi * 0.25 * 0.25;
  for (const Point& node : {Point{0.3, 0.2}, Point{0.1, 0.4}, Point{0.6, -0.1}}) {
    const WeightedSums all = integrate({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, node);
    EXPECT_NEAR(all.mass, whole, 1e-12);
    EXPECT_NEAR(all.first[0], whole * (0.3 - node[0]), 1e-12);
    EXPECT_NEAR(all.first[1], whole * (0.2 - node[1]), 1e-12);
    const double dx = node[0] - 0.3, dy = node[1] - 0.2;
    EXPECT_NEAR(all.second, whole * (0.25 * 0.25 + dx * dx + dy * dy), 1e-12);
  }
  const Ring triangle = {{0, 0}, {0.5, 0.1}, {0.2, 0.6}};
  const Point node = {0.25, 0.2};
  WeightedSums fine;
  const int n = 1500;
  const auto at = [&](double s, double t) {
    return Point{triangle[0][0] + s * (triangle[1][0] - triangle[0][0]) + t * (triangle[2][0] - triangle[0][0]),
                 triangle[0][1] + s * (triangle[1][1] - triangle[0][1]) + t * (triangle[2][1] - triangle[0][1])};
  };
  const double cell = 0.5 * (0.5 * 0.6 - 0.1 * 0.2) / (n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j)
      for (int upper = 0; upper < (i + j + 1 < n ? 2 : 1); ++upper) {
        const double third = upper ? 2.0 / 3.0 : 1.0 / 3.0;
        const Point x = at((i + third) / n, (j + third) / n);
        const double w = cell * (density.at(x) - 1.0), dx = x[0] - node[0], dy = x[1] - node[1];
        fine.mass += w;
        fine.first = {fine.first[0] + w * dx, fine.first[1] + w * dy};
        fine.second += w * (dx * dx + dy * dy);
      }
  const WeightedSums sums = integrate(triangle, node);
  EXPECT_NEAR(sums.mass, fine.mass, 1e-6 * fine.mass);
  EXPECT_NEAR(sums.first[0], fine.first[0], 1e-6 * fine.mass);
  EXPECT_NEAR(sums.first[1], fine.first[1], 1e-6 * fine.mass);
  EXPECT_NEAR(sums.second, fine.second, 1e-6 * fine.mass);
}

TEST(Places, OfGivenPointsAreFound) {
  const Outline outline(ell());
  const PlacedPoints placed = place_points(outline, {{1, 1}, {1.5, 0}, {2, 2}, {0, 3}, {0, 0}, {0, 1e-12}});
  const NodeKind kinds[] = {NodeKind::inner,  NodeKind::border, NodeKind::corner,
                            NodeKind::corner, NodeKind::corner, NodeKind::corner};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(placed.places[i].kind, kinds[i]) << i;
  EXPECT_EQ(placed.places[1], (Placement{NodeKind::border, 0, 1.5}));
  EXPECT_EQ(placed.places[3].chain, 5u);
  EXPECT_EQ(placed.places[5], placed.places[4]);
  EXPECT_THROW((void)place_points(outline, {{2.5, 2.5}}), Refusal);
}

}  // namespace
}  // namespace nodal::elastic::plane
