// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include <nodal/random.h>

#include "frames.h"

namespace nodal::elastic {
namespace {

Structure structure_of(const Frame& frame) { return {2, frame.nodes, frame.springs}; }

Frame grid(std::size_t columns, std::size_t rows, const char* topology, const plane::Point& corner = {0, 0}) {
  const Body body = plane::rectangle_body(corner, {static_cast<double>(columns - 1), static_cast<double>(rows - 1)});
  const bool bare = std::string(topology) == "grid";
  const Net net = make_grid_net(body, columns, rows, bare ? "single" : topology);
  Frame frame{net.nodes, net.springs};
  if (bare) std::erase_if(frame.springs, [](const Spring& s) { return s.direction[0] * s.direction[1] != 0.0; });
  return frame;
}

// Appends nodes and springs of another frame; the nodes of `onto` (pairs: other's node, ours) aren't repeated.
Frame joined(Frame frame, const Frame& other, const std::map<std::size_t, std::size_t>& onto = {}) {
  std::vector<std::size_t> now;
  for (std::size_t i = 0; i < other.nodes.size(); ++i) {
    const auto same = onto.find(i);
    now.push_back(same == onto.end() ? frame.nodes.size() : same->second);
    if (same == onto.end()) frame.nodes.push_back(other.nodes[i]);
  }
  for (const Spring& s : other.springs) frame.join(now[s.first], now[s.second]);
  return frame;
}

// Everything that a result promises.
void expect_consistent(const Rigidity& r, const Frame& frame, const std::vector<std::size_t>& fixed) {
  const std::set<std::size_t> held(fixed.begin(), fixed.end());
  EXPECT_EQ(r.freedoms, 2 * frame.nodes.size() - held.size());
  EXPECT_EQ(r.rank, dense_rank(structure_of(frame), fixed));
  EXPECT_EQ(r.mechanisms, r.freedoms - r.rank - r.rigid_motions);
  EXPECT_EQ(r.motions.size(), std::min(r.mechanisms, kShownMotions));
  EXPECT_EQ(r.moving.empty(), r.is_rigid());
  for (const std::vector<double>& u : r.motions) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
      const double length = std::hypot(u[2 * i], u[2 * i + 1]);
      largest = std::max(largest, length);
      if (length > 1e-5) {
        EXPECT_TRUE(std::ranges::binary_search(r.moving, i)) << i;
      }
    }
    EXPECT_NEAR(largest, 1.0, 1e-14);
    for (const std::size_t f : fixed) EXPECT_EQ(u[f], 0.0);
    for (const Spring& s : frame.springs)
      EXPECT_NEAR(s.direction[0] * (u[2 * s.second] - u[2 * s.first]) +
                      s.direction[1] * (u[2 * s.second + 1] - u[2 * s.first + 1]),
                  0.0, 1e-9);
    for (const std::vector<double>& v : r.motions) {
      if (&u != &v) {
        EXPECT_NEAR(std::inner_product(u.begin(), u.end(), v.begin(), 0.0), 0.0, 1e-9);
      }
    }
  }
}

Rigidity of(const Frame& frame, const std::vector<std::size_t>& fixed) {
  const Rigidity r = rigidity(structure_of(frame), fixed);
  expect_consistent(r, frame, fixed);
  return r;
}

Rigidity of_free(const Frame& frame) {
  const Rigidity r = free_rigidity(structure_of(frame));
  expect_consistent(r, frame, {});
  return r;
}

using Nodes = std::vector<std::size_t>;

TEST(Rigidity, HoldsForTriangulatedGrids) {
  for (const char* topology : {"single", "alternating", "crossed"}) {
    const Frame frame = grid(5, 4, topology);
    EXPECT_TRUE(of_free(frame).is_rigid());
    EXPECT_EQ(of_free(frame).rank, 2 * 20u - 3);
    EXPECT_TRUE(of(frame, {0, 1, 9}).is_rigid());
    EXPECT_EQ(of(frame, {}).mechanisms, 3u);      // nothing is held: two translations and a turn
    EXPECT_EQ(of(frame, {0, 2}).mechanisms, 2u);  // only sideways, along the lower edge
  }
}

// A grid of c × r nodes without diagonals: c(r−1) + (c−1)r springs, all independent: c + r − 3 mechanisms beside the
// rigid motions.
TEST(Rigidity, CountsTheMechanismsOfGridsWithoutDiagonals) {
  for (const auto& [columns, rows] : {std::pair{2u, 2u}, {3u, 3u}, {5u, 4u}, {7u, 2u}, {6u, 6u}}) {
    const Rigidity r = of_free(grid(columns, rows, "grid"));
    EXPECT_EQ(r.mechanisms, columns + rows - 3);
    EXPECT_FALSE(r.is_rigid());
  }
  EXPECT_EQ(of(grid(5, 4, "grid"), {0, 1, 3}).mechanisms, 6u);
}

TEST(Rigidity, NamesADanglingNode) {
  Frame frame = grid(4, 3, "crossed");
  frame.nodes.push_back({4.0, 1.5});
  frame.join(7, 12);
  EXPECT_EQ(of_free(frame).moving, Nodes{12});
  EXPECT_EQ(of_free(frame).mechanisms, 1u);
  const Rigidity held = of(frame, {0, 1, 3});
  EXPECT_EQ(held.moving, Nodes{12});
  EXPECT_EQ(describe(held), "a mechanism: 1 motion without resistance moves the node 12");
  // Across its one spring.
  EXPECT_NEAR(
      held.motions[0][24] * frame.springs.back().direction[0] + held.motions[0][25] * frame.springs.back().direction[1],
      0.0, 1e-12);
}

TEST(Rigidity, NamesANodeWithoutSprings) {
  Frame frame = grid(3, 3, "single");
  frame.nodes.push_back({5.0, 5.0});
  EXPECT_EQ(of_free(frame).moving, Nodes{9});
  EXPECT_EQ(of_free(frame).mechanisms, 2u);
}

// A plate of 4 × 4 nodes and one of 3 × 3 share one node: the smaller turns about it.
TEST(Rigidity, SeesThatAHingeTurns) {
  const Frame frame = joined(grid(4, 4, "crossed"), grid(3, 3, "crossed", {3, 3}), {{0, 15}});
  const Rigidity r = of_free(frame);
  EXPECT_EQ(r.mechanisms, 1u);
  EXPECT_EQ(r.moving, (Nodes{16, 17, 18, 19, 20, 21, 22, 23}));
  // The opposite corner is farthest from the hinge and moves across the line to it.
  EXPECT_NEAR(std::abs(r.motions[0][2 * 23]), std::numbers::sqrt2 / 2, 1e-9);
  EXPECT_NEAR(r.motions[0][2 * 23] + r.motions[0][2 * 23 + 1], 0.0, 1e-9);
}

TEST(Rigidity, SeesThatOneBarLeavesTwoMotions) {
  Frame frame = joined(grid(4, 4, "single"), grid(3, 3, "single", {5, 0}));
  EXPECT_EQ(of_free(frame).mechanisms, 3u);  // two plates apart
  frame.join(3, 16);
  EXPECT_EQ(of_free(frame).mechanisms, 2u);
  EXPECT_EQ(of_free(frame).moving, (Nodes{16, 17, 18, 19, 20, 21, 22, 23, 24}));
  frame.join(7, 16);
  frame.join(7, 19);
  EXPECT_TRUE(of_free(frame).is_rigid());
}

// Three parallel bars hold nothing across them.
TEST(Rigidity, SeesThatParallelBarsAreNoJoint) {
  Frame frame = joined(grid(4, 3, "crossed"), grid(3, 3, "crossed", {5, 0}));
  for (const auto& [i, j] : {std::pair{3u, 12u}, {7u, 15u}, {11u, 18u}}) frame.join(i, j);
  const Rigidity r = of_free(frame);
  EXPECT_EQ(r.mechanisms, 1u);
  EXPECT_EQ(r.moving, (Nodes{12, 13, 14, 15, 16, 17, 18, 19, 20}));
  EXPECT_NEAR(std::abs(r.motions[0][2 * 12 + 1]), 1.0, 1e-9);
}

// Straight chains between two pins: every inner node moves across, to first order.
TEST(Rigidity, CountsInfinitesimalMechanismsOfStraightChains) {
  for (const double angle : {0.0, 0.3, 1.2}) {
    Frame frame;
    for (int i = 0; i < 6; ++i) frame.nodes.push_back({1e3 + i * std::cos(angle), i * std::sin(angle)});
    for (std::size_t i = 0; i < 5; ++i) frame.join(i, i + 1);
    const Rigidity r = of(frame, {0, 1, 10, 11});
    EXPECT_EQ(r.mechanisms, 4u);
    EXPECT_EQ(r.moving, (Nodes{1, 2, 3, 4}));
  }
}

TEST(Rigidity, CallsASliverRigidAndShowsIt) {
  Frame frame;
  frame.nodes = {{0, 0}, {2, 0}, {1, 1e-6}};
  frame.join(0, 2);
  frame.join(1, 2);
  const Rigidity sliver = rigidity(structure_of(frame), {0, 1, 2, 3});
  EXPECT_TRUE(sliver.is_rigid());
  EXPECT_LT(sliver.smallest, 1e-5);
  EXPECT_GT(sliver.smallest, 1e-7);
  frame.nodes[2][1] = 1e-11;
  frame.springs.clear();
  frame.join(0, 2);
  frame.join(1, 2);
  EXPECT_EQ(rigidity(structure_of(frame), {0, 1, 2, 3}).mechanisms, 1u);
}

TEST(Rigidity, SeesPiecesThatNothingJoins) {
  const Frame pieces =
      joined(joined(grid(4, 4, "crossed"), grid(2, 2, "single", {10, 0})), grid(2, 3, "grid", {0, 10}));
  const Rigidity r = of_free(pieces);
  EXPECT_EQ(r.mechanisms, 3u + 3u + 2u);
  EXPECT_EQ(r.moving.front(), 16u);
  EXPECT_EQ(r.moving.size(), 10u);
  EXPECT_EQ(describe(r),
            "a mechanism: 8 motions without resistance move the nodes 16, 17, 18, 19, 20, 21, 22, 23, 24 "
            "and 25");
}

TEST(Rigidity, HasItsEnds) {
  const Frame two{.nodes = {{0, 0}, {1, 0}}, .springs = {}};
  EXPECT_EQ(of_free(two).mechanisms, 1u);
  EXPECT_EQ(of_free(two).moving, Nodes{1});
  EXPECT_TRUE(of_free({.nodes = {{0, 0}}, .springs = {}}).is_rigid());
  EXPECT_TRUE(of(two, {0, 1, 2, 3}).is_rigid());
  EXPECT_EQ(of(two, {0, 1, 2}).moving, Nodes{1});
  EXPECT_THROW((void)rigidity(structure_of({}), {}), std::invalid_argument);
  EXPECT_THROW((void)rigidity(structure_of(two), {4}), std::invalid_argument);
  EXPECT_THROW((void)rigidity(structure_of({two.nodes, {{0, 2, 1.0, {1, 0}}}}), {}), std::invalid_argument);
  EXPECT_THROW((void)rigidity(structure_of({{{0, 0}, {0, 0}}, {make_spring({{0, 0}, {0, 0}}, 0, 1)}}), {}),
               std::invalid_argument);
}

// Nodes at random, joined to their nearest ones: rigid, loose and in pieces, all kinds.
TEST(Rigidity, AgreesWithADenseDecompositionOfRandomNets) {
  std::set<std::size_t> seen;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    RandomStream random(seed);
    Frame frame;
    const std::size_t count = 6 + random.index(25), neighbours = 1 + random.index(4);
    for (std::size_t i = 0; i < count; ++i) frame.nodes.push_back({random.uniform(), random.uniform()});
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::size_t> near(count);
      std::iota(near.begin(), near.end(), std::size_t{0});
      std::ranges::sort(near, {}, [&](std::size_t j) {
        return std::hypot(frame.nodes[j][0] - frame.nodes[i][0], frame.nodes[j][1] - frame.nodes[i][1]);
      });
      for (std::size_t k = 1; k <= neighbours; ++k) pairs.insert(std::minmax(i, near[k]));
    }
    for (const auto& [i, j] : pairs) frame.join(i, j);
    seen.insert(of_free(frame).mechanisms);
    of(frame, {0, 1, 5});
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_TRUE(seen.contains(0));
  EXPECT_GT(seen.size(), 10u);
}

// Far more motions than are shown, and the size that nets go to.
TEST(Rigidity, GoesToTenThousandNodes) {
  EXPECT_TRUE(free_rigidity(structure_of(grid(100, 100, "single"))).is_rigid());
  EXPECT_TRUE(free_rigidity(structure_of(grid(2, 5000, "single"))).is_rigid());
  const Frame bare = grid(100, 100, "grid");
  const Rigidity r = free_rigidity(structure_of(bare));
  EXPECT_EQ(r.mechanisms, 197u);
  EXPECT_EQ(r.motions.size(), kShownMotions);
  EXPECT_LT(r.elongation, 1e-9);
  Frame hinged = joined(grid(90, 100, "crossed"), grid(10, 100, "crossed", {89, 99}), {{0, 8999}});
  const Rigidity hinge = free_rigidity(structure_of(hinged));
  EXPECT_EQ(hinge.mechanisms, 1u);
  EXPECT_EQ(hinge.moving.size(), 999u);
  EXPECT_EQ(hinge.moving.front(), 9000u);
}

}  // namespace
}  // namespace nodal::elastic
