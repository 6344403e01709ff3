// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <nodal/error.h>
#include <nodal/random.h>

#include "../bodies.h"
#include "points/random_points.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic::plane {
namespace {

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double area(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const Triangle& t : triangles) sum += 0.5 * twice_area(points[t[0]], points[t[1]], points[t[2]]);
  return sum;
}

std::string message(const std::vector<Point>& nodes, const std::vector<std::vector<std::size_t>>& outlines) {
  try {
    (void)constrained_triangles(nodes, outlines);
  } catch (const Refusal& e) {
    return e.what();
  }
  return "";
}

// The defining property, point by point: none within a triangle's circle.
TEST(Triangulation, LeavesCirclesEmpty) {
  EXPECT_TRUE(triangulation_available());
  RandomStream random(1);
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i) points.push_back({random.uniform(), random.uniform()});
  const auto triangles = delaunay_triangles(points);
  for (const Triangle& t : triangles) {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    EXPECT_GT(twice_area(a, b, c), 0.0);
    for (const Point& p : points) {
      const auto row = [&p](const Point& x) {
        const double dx = x[0] - p[0], dy = x[1] - p[1];
        return std::array{dx, dy, dx * dx + dy * dy};
      };
      const auto u = row(a), v = row(b), w = row(c);
      const double in_circle =
          u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
      EXPECT_LE(in_circle, 1e-14);
    }
  }
}

TEST(Triangulation, KnowsEveryNodesNeighbours) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2.1}, {0, 2}, {1, 1}};
  const Neighbours neighbours = delaunay_neighbours(points);
  ASSERT_EQ(neighbours.nodes(), 5u);
  const auto of = [&](std::size_t i) {
    return std::vector<std::size_t>(neighbours.of(i).begin(), neighbours.of(i).end());
  };
  EXPECT_EQ(of(0), (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_EQ(of(4), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(delaunay_triangles(points), (std::vector<Triangle>{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}}));
}

TEST(Triangulation, OfPointsOnALineJoinsThemInOrder) {
  const std::vector<Point> points = {{0, 0}, {3, 3}, {1, 1}, {2, 2}};
  EXPECT_TRUE(delaunay_triangles(points).empty());
  const Neighbours neighbours = delaunay_neighbours(points);
  EXPECT_EQ(neighbours.of(0).size(), 1u);
  EXPECT_EQ(neighbours.of(0)[0], 2u);
  EXPECT_EQ(neighbours.of(2).size(), 2u);
  EXPECT_EQ(delaunay_neighbours({{1, 1}}).of(0).size(), 0u);
  EXPECT_EQ(delaunay_neighbours({}).nodes(), 0u);
}

TEST(Triangulation, NamesNodesThatCoincideOrAreNotFinite) {
  const std::vector<Point> twice = {{0, 0}, {1, 0}, {0, 1}, {1, 0}};
  try {
    (void)delaunay_triangles(twice);
    FAIL() << "nodes 1 and 3 coincide";
  } catch (const Refusal& e) {
    EXPECT_NE(std::string(e.what()).find("nodes 1 and 3"), std::string::npos) << e.what();
  }
  EXPECT_THROW((void)delaunay_neighbours({{0, 0}, {std::nan(""), 0}}), Refusal);
}

// A square of side 3 with a square hole of side 1: the triangles make 8 of area, none of them in the hole.
TEST(ConstrainedTriangles, FillThePolygonAndNotItsHoles) {
  const std::vector<Point> nodes = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const auto triangles = constrained_triangles(nodes, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  EXPECT_EQ(triangles.size(), 8u);
  EXPECT_DOUBLE_EQ(area(nodes, triangles), 8.0);
}

TEST(ConstrainedTriangles, FollowAnOutlineThatTurnsInwards) {
  const std::vector<Point> nodes = ell().rings[0];
  const auto triangles = constrained_triangles(nodes, {{0, 1, 2, 3, 4, 5}});
  EXPECT_EQ(triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(area(nodes, triangles), 8.0);
}

TEST(ConstrainedTriangles, CoverRandomBodiesExactly) {
  RandomStream random(21);
  for (int trial = 0; trial < 100; ++trial) {
    const Body body = random_star(random);
    std::vector<Point> nodes;
    std::vector<std::vector<std::size_t>> outlines;
    for (const Ring& ring : body.rings) {
      outlines.emplace_back(ring.size());
      std::iota(outlines.back().begin(), outlines.back().end(), nodes.size());
      nodes.insert(nodes.end(), ring.begin(), ring.end());
    }
    const Outline outline(body);
    RandomStream draw(static_cast<std::uint64_t>(trial));
    const PlacedPoints points =
        make_random_points(outline, {.inner = 30, .border = least_border_points(outline)}, draw);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.places[i].kind == NodeKind::inner) nodes.push_back(points.points[i]);
    const auto triangles = constrained_triangles(nodes, outlines);
    // Euler: triangles = 2·(nodes − 1) − border nodes + 2·holes.
    const std::size_t border = nodes.size() - 30, holes = body.rings.size() - 1;
    EXPECT_EQ(triangles.size(), 2 * (nodes.size() - 1) - border + 2 * holes);
    EXPECT_NEAR(area(nodes, triangles), outline.area(), 1e-13);
    for (const Triangle& t : triangles) EXPECT_EQ(t[0], *std::ranges::min_element(t));
  }
}

TEST(ConstrainedTriangles, SayWhatIsWrong) {
  const std::vector<Point> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_NE(message(square, {{0, 1, 3, 2}}).find("crosses"), std::string::npos);
  EXPECT_NE(message(square, {{0, 1}}).find("at least 3"), std::string::npos);
  EXPECT_NE(message(square, {{0, 1, 2}}).find("node 3 at (0, 2) lies outside"), std::string::npos);
  std::vector<Point> more = square;
  more.push_back({1, 0});
  EXPECT_NE(message(more, {{0, 1, 2, 3}}).find("passes through node 4"), std::string::npos);
  EXPECT_NE(message(more, {{0, 4, 1, 2, 3, 4}}).find("meet at node 4"), std::string::npos);
  more.back() = {1, 1e-12};
  EXPECT_NE(message(more, {{0, 1, 2, 3}}).find("without height"), std::string::npos);
  EXPECT_NE(message({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}}), "");
  EXPECT_EQ(message(square, {{0, 1, 2, 3}}), "");
}

}  // namespace
}  // namespace nodal::elastic::plane
