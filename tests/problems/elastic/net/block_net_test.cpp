// SPDX-License-Identifier: GPL-3.0-or-later
// Nets over a box: springs, tetrahedra, surface, kinds of nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <nodal/error.h>

#include "../../../support/messages.h"
#include "../block.h"

namespace nodal::elastic {
namespace {

using Counts = std::array<std::size_t, 3>;
using Joined = std::set<std::array<std::size_t, 2>>;

constexpr Counts kCounts = {4, 3, 5};
constexpr std::array<double, 3> kSize = {1.5, 1.0, 6.0};

Net block(const std::string& topology, const Counts& counts = kCounts) {
  return make_block_net(Body{.name = "box", .rings = {}, .box = Extent{{1.0, -2.0, 3.0}, {2.5, -1.0, 9.0}}}, counts,
                        topology);
}

std::size_t node_at(const Counts& counts, std::size_t i, std::size_t j, std::size_t k) {
  return (k * counts[1] + j) * counts[0] + i;
}

std::array<std::size_t, 2> pair_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

Joined springs_of(const Net& net) {
  Joined pairs;
  for (const Spring& s : net.springs) pairs.insert({s.first, s.second});
  EXPECT_EQ(pairs.size(), net.springs.size()) << "a spring stands twice";
  return pairs;
}

// How many cells, faces between nodes and edges a grid has.
struct Pieces {
  explicit Pieces(const Counts& n)
      : edges((n[0] - 1) * n[1] * n[2] + n[0] * (n[1] - 1) * n[2] + n[0] * n[1] * (n[2] - 1)),
        faces((n[0] - 1) * (n[1] - 1) * n[2] + (n[0] - 1) * n[1] * (n[2] - 1) + n[0] * (n[1] - 1) * (n[2] - 1)),
        cells((n[0] - 1) * (n[1] - 1) * (n[2] - 1)) {}
  std::size_t edges, faces, cells;
};

class BlockNet : public testing::TestWithParam<std::string> {};

TEST_P(BlockNet, HasTheSpringsOfItsTopology) {
  for (const Counts& counts : {Counts{2, 2, 2}, {3, 3, 3}, {4, 3, 5}, {2, 6, 3}}) {
    const Pieces n(counts);
    const std::size_t diagonals = GetParam() == "single"        ? n.faces + n.cells
                                  : GetParam() == "alternating" ? n.faces
                                  : GetParam() == "faces"       ? 2 * n.faces
                                                                : 2 * n.faces + 4 * n.cells;
    EXPECT_EQ(springs_of(block(GetParam(), counts)).size(), n.edges + diagonals);
  }
}

TEST_P(BlockNet, PutsNodesOnAGridXFastest) {
  const Net net = block(GetParam());
  ASSERT_EQ(net.nodes.size(), 60u);
  EXPECT_EQ(net.dimension, 3u);
  EXPECT_EQ(net.nodes.front(), (Vector{1.0, -2.0, 3.0}));
  EXPECT_EQ(net.nodes.back(), (Vector{2.5, -1.0, 9.0}));  // to the last bit: it lies on the border
  EXPECT_EQ(net.nodes[node_at(kCounts, 1, 0, 0)], (Vector{1.5, -2.0, 3.0}));
  EXPECT_EQ(net.nodes[node_at(kCounts, 0, 1, 0)], (Vector{1.0, -1.5, 3.0}));
  EXPECT_EQ(net.nodes[node_at(kCounts, 0, 0, 1)], (Vector{1.0, -2.0, 4.5}));
  for (const Spring& s : net.springs) {
    EXPECT_LT(s.first, s.second);
    EXPECT_NEAR(norm(s.direction), 1.0, 1e-15);
    EXPECT_NEAR(dot(s.direction, net.nodes[s.second] - net.nodes[s.first]), s.length, 1e-15 * 8.0);
  }
}

TEST_P(BlockNet, TetrahedraFillTheBoxOnce) {
  const Net net = block(GetParam());
  double volume = 0.0;
  for (const Tetrahedron& t : net.tetrahedra) {
    const Vector& o = net.nodes[t.nodes[0]];
    const double of_it =
        dot(cross(net.nodes[t.nodes[1]] - o, net.nodes[t.nodes[2]] - o), net.nodes[t.nodes[3]] - o) / 6.0;
    EXPECT_GT(of_it, 0.0);
    volume += t.share * of_it;
  }
  EXPECT_NEAR(volume, kSize[0] * kSize[1] * kSize[2], 1e-13 * 9.0);  // of some hundred terms
}

TEST_P(BlockNet, SpringsAreTheEdgesOfTetrahedra) {
  const Net net = block(GetParam());
  Joined edges;
  for (const Tetrahedron& t : net.tetrahedra)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) edges.insert(pair_of(t.nodes[a], t.nodes[b]));
  EXPECT_EQ(edges, springs_of(net));
}

// Each triangle inside the body belongs to as much of tetrahedra on the one side as on the other; on the surface to one
// side only. For topologies of one triangulation that means: they fit together without gaps.
TEST_P(BlockNet, TetrahedraFitTogether) {
  if (GetParam() == "faces" || GetParam() == "crossed") return;  // several triangulations at once
  const Net net = block(GetParam());
  std::map<std::array<std::size_t, 3>, int> sides;
  for (const Tetrahedron& t : net.tetrahedra)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::size_t, 3> triangle{};
      for (std::size_t a = 0, to = 0; a < 4; ++a)
        if (a != left_out) triangle[to++] = t.nodes[a];
      std::ranges::sort(triangle);
      ++sides[triangle];
    }
  for (const auto& [triangle, count] : sides) {
    bool on_face = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const double end : {net.body.box->low[axis], net.body.box->high[axis]})
        on_face =
            on_face || std::ranges::all_of(triangle, [&](std::size_t node) { return net.nodes[node][axis] == end; });
    EXPECT_EQ(count, on_face ? 1 : 2);
  }
}

TEST_P(BlockNet, SurfaceCloses) {
  const Net net = block(GetParam());
  Vector sum{};
  double area = 0.0;
  for (const Facet& facet : net.border) {
    for (std::size_t a = 0; a < 3; ++a) sum[a] += facet.area[a];
    area += norm(facet.area);
    // Outward, and as its corners say, which go round it.
    Vector middle{};
    for (const std::size_t node : facet.nodes)
      for (std::size_t a = 0; a < 3; ++a) middle[a] += 0.25 * net.nodes[node][a];
    const Vector of_corners = cross(net.nodes[facet.nodes[2]] - net.nodes[facet.nodes[0]],
                                    net.nodes[facet.nodes[3]] - net.nodes[facet.nodes[1]]);
    const Vector centre = {1.75, -1.5, 6.0};
    EXPECT_GT(dot(facet.area, middle - centre), 0.0);
    EXPECT_NEAR(norm(of_corners), 2.0 * norm(facet.area), 1e-14);
    EXPECT_NEAR(norm(cross(of_corners, facet.area)), 0.0, 1e-14);
  }
  EXPECT_NEAR(norm(sum), 0.0, 1e-13);
  EXPECT_NEAR(area, 2.0 * (1.5 * 1.0 + 1.0 * 6.0 + 6.0 * 1.5), 1e-13 * area);
}

TEST_P(BlockNet, KnowsWhichNodesAreOnTheBorder) {
  const Net net = block(GetParam());
  for (std::size_t k = 0; k < kCounts[2]; ++k)
    for (std::size_t j = 0; j < kCounts[1]; ++j)
      for (std::size_t i = 0; i < kCounts[0]; ++i) {
        const int ends = (i % 3 == 0) + (j % 2 == 0) + (k % 4 == 0);
        const NodeKind expected = ends == 3 ? NodeKind::corner : ends > 0 ? NodeKind::border : NodeKind::inner;
        EXPECT_EQ(net.kinds[node_at(kCounts, i, j, k)], expected);
      }
}

INSTANTIATE_TEST_SUITE_P(Topologies, BlockNet, testing::Values("single", "alternating", "faces", "crossed"),
                         [](const auto& p) { return p.param; });

// Every diagonal starts at a lowest corner: of its face, or of its cell.
TEST(BlockDiagonals, OfSingleRise) {
  for (const Spring& s : block("single").springs)
    for (const double d : s.direction) EXPECT_GE(d, 0.0);
}

// A face's diagonal starts at its lowest corner where that corner's i + j + k is even; so diagonals join even nodes.
TEST(BlockDiagonals, OfAlternatingJoinEvenNodes) {
  const Net net = block("alternating");
  std::set<std::size_t> even;
  for (std::size_t k = 0; k < kCounts[2]; ++k)
    for (std::size_t j = 0; j < kCounts[1]; ++j)
      for (std::size_t i = 0; i < kCounts[0]; ++i)
        if ((i + j + k) % 2 == 0) even.insert(node_at(kCounts, i, j, k));
  for (const Spring& s : net.springs) {
    const auto axes = std::ranges::count_if(s.direction, [](double d) { return d != 0.0; });
    EXPECT_EQ(even.contains(s.first) && even.contains(s.second), axes == 2) << s.first << ' ' << s.second;
  }
  const Joined pairs = springs_of(net);
  EXPECT_TRUE(pairs.contains(pair_of(node_at(kCounts, 0, 0, 0), node_at(kCounts, 1, 1, 0))));
  EXPECT_TRUE(pairs.contains(pair_of(node_at(kCounts, 2, 0, 0), node_at(kCounts, 1, 1, 0))));
}

TEST(BlockNets, AreRefused) {
  const auto refusal = [](const std::string& topology, const Counts& counts) {
    return toy::message_of<Refusal>([&] { (void)block(topology, counts); });
  };
  EXPECT_EQ(refusal("grid", {3, 3, 3}), "a block can't be connected by 'grid'");
  EXPECT_EQ(refusal("faces", {3, 1, 3}), "a block needs at least 2 × 2 × 2 nodes");
  EXPECT_EQ(toy::message_of<Refusal>([] {
              (void)make_block_net(plane::rectangle_body({0, 0}, {1, 1}), {2, 2, 2}, "faces");
            }),
            "a block of nodes needs a body that is a box");
}

}  // namespace
}  // namespace nodal::elastic
