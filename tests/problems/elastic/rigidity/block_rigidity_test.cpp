// SPDX-License-Identifier: GPL-3.0-or-later
// Mechanisms in space, against a dense decomposition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <nodal/random.h>

#include "../block.h"
#include "frames.h"

namespace nodal::elastic {
namespace {

Frame block(const std::array<std::size_t, 3>& counts, const std::string& topology, const Vector& corner = {}) {
  Extent box{corner, corner};
  for (std::size_t a = 0; a < 3; ++a) box.high[a] += static_cast<double>(counts[a] - 1);
  const bool bare = topology == "grid";
  const Net net =
      make_block_net(Body{.name = "box", .rings = {}, .box = box}, counts, bare ? std::string("single") : topology);
  Frame frame{net.nodes, net.springs};
  if (bare) std::erase_if(frame.springs, [](const Spring& s) { return std::ranges::count(s.direction, 0.0) != 2; });
  return frame;
}

// Appends another frame; the nodes of it that lie where ours do are the same ones.
Frame joined(Frame frame, const Frame& other) {
  std::vector<std::size_t> now;
  for (const Vector& p : other.nodes) {
    const auto same = std::ranges::find(frame.nodes, p);
    now.push_back(static_cast<std::size_t>(same - frame.nodes.begin()));
    if (same == frame.nodes.end()) frame.nodes.push_back(p);
  }
  for (const Spring& s : other.springs) {
    const auto ends = std::minmax(now[s.first], now[s.second]);
    const bool there = std::ranges::any_of(
        frame.springs, [&](const Spring& o) { return o.first == ends.first && o.second == ends.second; });
    if (!there) frame.join(ends.first, ends.second);
  }
  return frame;
}

// Everything that a result promises.
Rigidity checked(const Rigidity& r, const Frame& frame, const std::vector<std::size_t>& fixed) {
  const Freedoms freedoms{3, frame.nodes.size()};
  EXPECT_EQ(r.freedoms, freedoms.size() - fixed.size());
  EXPECT_EQ(r.rank, dense_rank({3, frame.nodes, frame.springs}, fixed));
  EXPECT_EQ(r.mechanisms, r.freedoms - r.rank - r.rigid_motions);
  EXPECT_EQ(r.motions.size(), std::min(r.mechanisms, kShownMotions));
  EXPECT_EQ(r.moving.empty(), r.is_rigid());
  for (const std::vector<double>& u : r.motions) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
      const double length = norm(freedoms.vector_at(u, i));
      largest = std::max(largest, length);
      if (length > 1e-5) {
        EXPECT_TRUE(std::ranges::binary_search(r.moving, i)) << i;
      }
    }
    EXPECT_NEAR(largest, 1.0, 1e-14);
    for (const std::size_t f : fixed) EXPECT_EQ(u[f], 0.0);
    for (const Spring& s : frame.springs)
      EXPECT_NEAR(dot(s.direction, freedoms.vector_at(u, s.second) - freedoms.vector_at(u, s.first)), 0.0, 1e-9);
  }
  return r;
}

Rigidity of_free(const Frame& frame) { return checked(free_rigidity({3, frame.nodes, frame.springs}), frame, {}); }
Rigidity of(const Frame& frame, const std::vector<std::size_t>& fixed) {
  return checked(rigidity({3, frame.nodes, frame.springs}, fixed), frame, fixed);
}

TEST(BlockRigidity, HoldsForEveryTopology) {
  for (const char* topology : {"single", "alternating", "faces", "crossed"}) {
    const Frame frame = block({4, 3, 3}, topology);
    const Rigidity free = of_free(frame);
    EXPECT_TRUE(free.is_rigid()) << topology;
    EXPECT_EQ(free.rigid_motions, 6u);
    EXPECT_EQ(free.rank, 3 * 36u - 6);
    EXPECT_TRUE(of(frame, {0, 1, 2, 3 * 3 + 1, 3 * 3 + 2, 3 * 8 + 2}).is_rigid()) << topology;
    EXPECT_EQ(of(frame, {0, 1, 2, 3 * 3 + 1, 3 * 3 + 2}).mechanisms, 1u);  // a turn about the line through both
    EXPECT_EQ(of(frame, {}).mechanisms, 6u);
  }
}

// Without diagonals every spring is independent; what they leave beside the six rigid motions is mechanisms.
TEST(BlockRigidity, CountsTheMechanismsOfGridsWithoutDiagonals) {
  for (const std::array<std::size_t, 3>& n : {std::array<std::size_t, 3>{2, 2, 2}, {3, 3, 3}, {4, 3, 2}}) {
    const Frame frame = block(n, "grid");
    const std::size_t nodes = n[0] * n[1] * n[2];
    const std::size_t springs = (n[0] - 1) * n[1] * n[2] + n[0] * (n[1] - 1) * n[2] + n[0] * n[1] * (n[2] - 1);
    ASSERT_EQ(frame.springs.size(), springs);
    EXPECT_EQ(of_free(frame).mechanisms, 3 * nodes - 6 - springs);
  }
}

// Two blocks with one node in common turn about it in three ways, with two nodes about the line through these, with
// three not in a row not at all.
TEST(BlockRigidity, SeesHinges) {
  const Frame large = block({3, 3, 3}, "crossed");
  const Rigidity at_node = of_free(joined(large, block({2, 2, 2}, "crossed", {2, 2, 2})));
  EXPECT_EQ(at_node.mechanisms, 3u);
  EXPECT_EQ(at_node.moving, (std::vector<std::size_t>{27, 28, 29, 30, 31, 32, 33}));
  const Rigidity on_edge = of_free(joined(large, block({2, 2, 2}, "crossed", {2, 2, 1})));
  EXPECT_EQ(on_edge.mechanisms, 1u);
  EXPECT_EQ(on_edge.moving, (std::vector<std::size_t>{27, 28, 29, 30, 31, 32}));
  EXPECT_TRUE(of_free(joined(large, block({2, 2, 2}, "crossed", {2, 1, 1}))).is_rigid());
}

TEST(BlockRigidity, NamesANodeThatTooFewSpringsHold) {
  Frame frame = block({3, 3, 3}, "faces");
  frame.nodes.push_back({3.0, 1.2, 1.4});
  frame.join(14, 27);
  EXPECT_EQ(of_free(frame).mechanisms, 2u);
  frame.join(17, 27);
  EXPECT_EQ(of_free(frame).mechanisms, 1u);
  EXPECT_EQ(describe(of_free(frame)), "a mechanism: 1 motion without resistance moves the node 27");
  frame.join(23, 27);
  EXPECT_TRUE(of_free(frame).is_rigid());
}

// Two nodes or a straight row have five motions that lengthen nothing as bodies, one node has three: turns about the
// line, or about the node, aren't motions at all.
TEST(BlockRigidity, CountsTheMotionsOfRowsAndOfANode) {
  EXPECT_TRUE(of_free({.nodes = {{1, 2, 3}}, .springs = {}}).is_rigid());
  EXPECT_EQ(of_free({.nodes = {{1, 2, 3}}, .springs = {}}).rigid_motions, 3u);
  Frame row{.nodes = {{0, 0, 0}, {1, 2, -1}}, .springs = {}};
  EXPECT_EQ(of_free(row).mechanisms, 1u);
  row.join(0, 1);
  EXPECT_TRUE(of_free(row).is_rigid());
  EXPECT_EQ(of_free(row).rigid_motions, 5u);
  row.nodes.push_back({2, 4, -2});
  row.join(1, 2);
  EXPECT_EQ(of_free(row).rigid_motions, 5u);
  EXPECT_EQ(of_free(row).mechanisms, 2u);  // the middle leaves the line, either way across
}

// A flat frame bends out of its plane.
TEST(BlockRigidity, SeesThatAFlatFrameBends) {
  Frame flat{.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, .springs = {}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) flat.join(i, j);
  EXPECT_EQ(of_free(flat).mechanisms, 1u);
  flat.nodes.push_back({0.5, 0.5, 1.0});
  for (std::size_t i = 0; i < 4; ++i) flat.join(i, 4);
  EXPECT_TRUE(of_free(flat).is_rigid());
}

// Nodes at random, joined to their nearest ones: rigid, loose and in pieces, all kinds.
TEST(BlockRigidity, AgreesWithADenseDecompositionOfRandomNets) {
  int rigid = 0, loose = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomStream random(seed);
    Frame frame;
    const std::size_t count = 6 + random.index(20), neighbours = 2 + random.index(6);
    for (std::size_t i = 0; i < count; ++i)
      frame.nodes.push_back({random.uniform(), random.uniform(), random.uniform()});
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::size_t> near(count);
      for (std::size_t j = 0; j < count; ++j) near[j] = j;
      std::ranges::sort(near, {}, [&](std::size_t j) { return distance(frame.nodes[i], frame.nodes[j]); });
      for (std::size_t k = 1; k <= std::min(neighbours, count - 1); ++k) pairs.insert(std::minmax(i, near[k]));
    }
    for (const auto& [i, j] : pairs) frame.join(i, j);
    ++(of_free(frame).is_rigid() ? rigid : loose);
  }
  EXPECT_GE(rigid, 5);
  EXPECT_GE(loose, 5);
}

}  // namespace
}  // namespace nodal::elastic
