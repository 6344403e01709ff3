// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes are joined: sides, flips, slivers, nearest ones; and whole nets by a study.
#include "springs/connections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <nodal/elastic/stiffness.h>
#include <nodal/random.h>

#include "../plate.h"
#include "geometry/plane/segment.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

using Pairs = std::vector<NodePair>;

TEST(Connections, SidesKnowWhatLiesOpposite) {
  const std::vector<TriangleSide> sides = sides_of({{0, 1, 2}, {1, 3, 2}});
  ASSERT_EQ(sides.size(), 5u);
  EXPECT_EQ(side_pairs({{0, 1, 2}, {1, 3, 2}}), (Pairs{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(sides[2].opposite, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(sides[0].opposite, (std::vector<std::size_t>{2}));
}

TEST(Connections, FlipsCrossAnInnerSideOfAConvexQuadrilateralOnly) {
  const std::vector<Triangle> two = {{0, 1, 2}, {1, 3, 2}};
  EXPECT_EQ(flip_pairs({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, two), (Pairs{{0, 3}}));
  // Node 3 pulled so far in that the segment from 0 would leave the two triangles.
  EXPECT_EQ(flip_pairs({{0, 0}, {1, 0}, {0, 1}, {3, -1}}, two), Pairs{});
}

// Node 3 lies 1e-4 above the middle of the lower border: the triangle below it is a sliver with its long side on the
// border. The same triangle turned over, its long side inside, stays.
TEST(Connections, SliversAreDroppedFromTheBorderAlone) {
  const std::vector<plane::Point> nodes = {{0, 0}, {2, 0}, {1, 1}, {1, 1e-4}, {1, -1}};
  std::vector<Triangle> border = {{0, 1, 3}, {0, 3, 2}, {3, 1, 2}};
  EXPECT_EQ(drop_slivers(nodes, border, kLeastTriangleHeight), 1u);
  EXPECT_EQ(border, (std::vector<Triangle>{{0, 3, 2}, {3, 1, 2}}));
  std::vector<Triangle> inside = {{0, 1, 3}, {0, 3, 2}, {3, 1, 2}, {0, 4, 1}};
  EXPECT_EQ(drop_slivers(nodes, inside, kLeastTriangleHeight), 0u);
  EXPECT_EQ(inside.size(), 4u);
}

// Against all distances, for points in clusters and along a line too.
TEST(Connections, NearestOnesAreTheNearest) {
  RandomStream random(5);
  for (int round = 0; round < 30; ++round) {
    std::vector<plane::Point> nodes;
    const double height = round % 3 == 0 ? 1e-3 : 1.0;
    for (int i = 0; i < 60; ++i) {
      const bool clustered = round % 2 == 1 && i % 2 == 1;
      nodes.push_back({clustered ? 0.5 + 0.01 * random.uniform() : random.uniform(), height * random.uniform()});
    }
    const std::size_t count = 1 + random.index(8);
    std::set<NodePair> expected;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<std::pair<double, std::size_t>> by_distance;
      for (std::size_t j = 0; j < nodes.size(); ++j)
        if (j != i) by_distance.emplace_back(plane::distance(nodes[i], nodes[j]), j);
      std::ranges::sort(by_distance);
      for (std::size_t k = 0; k < count; ++k) expected.insert(std::minmax(i, by_distance[k].second));
    }
    EXPECT_EQ(nearest_pairs(nullptr, nodes, count), Pairs(expected.begin(), expected.end())) << "round " << round;
  }
}

std::shared_ptr<const ElasticProblem> problem(const std::string& body, const std::string& points,
                                              const std::string& springs) {
  return as_elastic(parse_study("[study]\nname = \"s\"\n[problem]\nkind = \"elastic\"\nbody = " + body + "\npoints = " +
                                    points + "\nsprings = " + springs + "\nloads = { supports = \"minimal\" }\n",
                                "s.toml", components()));
}

// A U: nodes on both sides of the notch are nearer to each other than to their neighbours along it.
constexpr const char* kNotched =
    "{ outline = [[0, 0], [3, 0], [3, 3], [1.6, 3], [1.6, 1], [1.4, 1], [1.4, 3], [0, 3]] }";

void expect_within(const Net& net) {
  const plane::Outline outline(net.body);
  for (const Spring& s : net.springs)
    EXPECT_TRUE(outline.covers(in_plane(net.nodes[s.first]), in_plane(net.nodes[s.second])))
        << s.first << "-" << s.second;
}

TEST(Connections, NearestDoesNotReachAcrossANotch) {
  const auto near =
      problem(kNotched, "{ layout = \"random\", total = 60 }",
              "{ topology = \"nearest\", nearest = 8, initial = { rule = \"paper\", scale = \"best\" } }");
  expect_within(near->net());
}

class Triangulated : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!triangulation_available()) GTEST_SKIP() << "needs CGAL";
  }
};

TEST_P(Triangulated, NetsStayInTheBodyAndCarryItsEnergy) {
  for (const char* body : {kNotched, "{ shape = \"ring\", radius = 2, inner_radius = 1 }"}) {
    const auto net = problem(body, "{ layout = \"voronoi\", total = 120, iterations = 5 }",
                             std::string("{ topology = \"") + GetParam() + "\" }");
    // Outlines of polygons with a node at every corner; on a ring chords of the hole run through it by a hair.
    if (body == kNotched) expect_within(net->net());
    if (net->net().triangles.empty()) continue;
    double area = 0.0, sum = 0.0;
    for (const Triangle& t : net->net().triangles) {
      const Vector &a = net->net().nodes[t[0]], &b = net->net().nodes[t[1]], &c = net->net().nodes[t[2]];
      area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    const std::vector<double> k = area_stiffness(net->net(), Material{.young = 2.0});
    for (std::size_t e = 0; e < k.size(); ++e) {
      EXPECT_GT(k[e], 0.0);
      sum += k[e] * net->net().springs[e].length * net->net().springs[e].length;
    }
    EXPECT_NEAR(sum, 3.0 * 2.0 * area, 1e-12 * sum);
  }
}

INSTANTIATE_TEST_SUITE_P(Topologies, Triangulated, testing::Values("delaunay", "delaunay-flip", "voronoi-neighbours"));

TEST(Connections, RegionsThatTouchAreDelaunayNeighbours) {
  if (!triangulation_available()) GTEST_SKIP() << "needs CGAL";
  const auto regions = problem("{ size = [2, 1] }", "{ layout = \"voronoi\", total = 80, iterations = 3 }",
                               "{ topology = \"voronoi-neighbours\" }");
  const plane::Neighbours neighbours = plane::delaunay_neighbours(in_plane(regions->net().nodes));
  for (const Spring& s : regions->net().springs) {
    const auto of = neighbours.of(s.first);
    EXPECT_TRUE(std::ranges::find(of, s.second) != of.end());
  }
  EXPECT_GT(regions->net().springs.size(), 2 * regions->net().nodes.size());
}

}  // namespace
}  // namespace nodal::elastic
