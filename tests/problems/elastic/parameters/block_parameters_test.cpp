// SPDX-License-Identifier: GPL-3.0-or-later
// How springs of blocks are tied.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "../block.h"
#include "parameters/symmetry.h"

namespace nodal::elastic {
namespace {

Net block_net(const std::array<std::size_t, 3>& counts, const Vector& size, const std::string& topology = "crossed") {
  return make_block_net(
      Body{.name = "box", .rings = {}, .box = Extent{{1.0, 2.0, -3.0}, {1.0 + size[0], 2.0 + size[1], size[2] - 3.0}}},
      counts, topology);
}

std::vector<std::string> names(const Net& net, const ParameterRule& rule) {
  const Parameters parameters(net, rule);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < parameters.size(); ++i) all.push_back(parameters.name(i));
  return all;
}

Symmetry symmetry_of(const Net& net) { return find_symmetry(3, net.nodes, net.springs); }

TEST(BlockSymmetry, IsThatOfTheBoxAndItsGrid) {
  const Symmetry cube = symmetry_of(block_net({3, 3, 3}, {2, 2, 2}));
  EXPECT_EQ(cube.rotations, 24u);
  EXPECT_EQ(cube.reflections, 24u);
  EXPECT_EQ(symmetry_of(block_net({4, 4, 4}, {2, 2, 2}, "faces")).order(), 48u);
  EXPECT_EQ(symmetry_of(block_net({3, 3, 4}, {2, 2, 3})).order(), 16u);
  EXPECT_EQ(symmetry_of(block_net({4, 3, 4}, {3, 2, 3}, "faces")).order(), 16u);
  EXPECT_EQ(symmetry_of(block_net({2, 3, 4}, {1, 2, 3})).order(), 8u);
  EXPECT_EQ(symmetry_of(block_net({3, 3, 3}, {1.0, 1.1, 1.2})).order(), 8u);
  EXPECT_EQ(symmetry_of(block_net({3, 3, 3}, {2.0, 2.0, 2.2})).order(), 16u);
  // A cube, but for how its nodes are counted.
  EXPECT_EQ(symmetry_of(block_net({3, 3, 5}, {2, 2, 2})).order(), 16u);
}

// Kuhn's cells all rise along one body diagonal: its three turns, each with or without exchanging two axes and with or
// without the point reflection. Five tetrahedra per cell have the cube's full symmetry where the middle of the block
// is a node, and half of it, the tetrahedron's, where it is the middle of a cell.
TEST(BlockSymmetry, OfDiagonalsIsWhatTheyLeave) {
  EXPECT_EQ(symmetry_of(block_net({3, 3, 3}, {2, 2, 2}, "single")).order(), 12u);
  EXPECT_EQ(symmetry_of(block_net({3, 3, 3}, {2, 2, 2}, "alternating")).order(), 48u);
  EXPECT_EQ(symmetry_of(block_net({4, 4, 4}, {3, 3, 3}, "alternating")).order(), 24u);
}

TEST(BlockSymmetry, IsLostByAMovedNode) {
  Net net = block_net({3, 3, 3}, {2, 2, 2});
  net.nodes[0][0] += 1e-6;
  EXPECT_EQ(symmetry_of(net).order(), 2u);  // the exchange of y and z leaves the corner's way along x alone
  net.nodes[0][1] += 3e-6;
  net.nodes[0][2] -= 1e-6;
  EXPECT_EQ(symmetry_of(net).order(), 1u);
}

// Against the 48 signed permutations of axes, written out on the indices of nodes.
TEST(BlockSymmetry, TiesWhatPermutedAndReflectedAxesExchange) {
  const std::size_t n = 4;
  const Net net = block_net({n, n, n}, {3, 3, 3});
  const Parameters parameters(net, "symmetric");
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::map<std::array<std::size_t, 2>, std::size_t> spring;
  for (std::size_t e = 0; e < net.springs.size(); ++e) spring[{net.springs[e].first, net.springs[e].second}] = e;
  std::vector<std::set<std::size_t>> orbit(net.springs.size());
  do {
    for (unsigned flips = 0; flips < 8; ++flips) {
      const auto image = [&](std::size_t node) {
        const std::array<std::size_t, 3> at = {node % n, node / n % n, node / (n * n)};
        std::array<std::size_t, 3> to{};
        for (std::size_t a = 0; a < 3; ++a) to[a] = flips >> a & 1u ? n - 1 - at[axes[a]] : at[axes[a]];
        return (to[2] * n + to[1]) * n + to[0];
      };
      for (std::size_t e = 0; e < net.springs.size(); ++e) {
        const std::size_t a = image(net.springs[e].first), b = image(net.springs[e].second);
        orbit[e].insert(spring.at({std::min(a, b), std::max(a, b)}));
      }
    }
  } while (std::ranges::next_permutation(axes).found);
  for (std::size_t e = 0; e < net.springs.size(); ++e) {
    const std::span<const std::size_t> tied = parameters.springs_of(parameters.coordinate_of(e));
    EXPECT_EQ(std::set<std::size_t>(tied.begin(), tied.end()), orbit[e]) << e;
  }
}

TEST(BlockDirections, AreAxesFacesAndCells) {
  EXPECT_EQ(names(block_net({4, 3, 5}, {3, 2, 4}), "by-direction"),
            (std::vector<std::string>{"ln k along x", "ln k along y", "ln k face diagonal", "ln k along z",
                                      "ln k body diagonal"}));
  EXPECT_EQ(names(block_net({4, 3, 5}, {3, 2, 4}, "faces"), "by-direction").size(), 4u);
  const Net net = block_net({3, 3, 3}, {1.0, 2.0, 5.0});
  const Parameters parameters(net, "by-direction");
  for (std::size_t e = 0; e < net.springs.size(); ++e) {
    const auto axes = std::ranges::count_if(net.springs[e].direction, [](double d) { return d != 0.0; });
    const std::string name = parameters.group_name(e);
    EXPECT_EQ(name == "body diagonal" ? 3 : name == "face diagonal" ? 2 : 1, axes);
    if (axes == 1) {
      EXPECT_EQ(net.springs[e].direction[static_cast<std::size_t>(name.back() - 'x')], 1.0) << name;
    }
  }
}

TEST(BlockLengths, AreThoseOfEdgesAndDiagonals) {
  EXPECT_EQ(names(block_net({3, 3, 3}, {2, 2, 2}), "by-length"),
            (std::vector<std::string>{"ln k 1 m", "ln k 1.414 m", "ln k 1.732 m"}));
  EXPECT_EQ(names(block_net({3, 3, 3}, {2, 2, 2}), "uniform").size(), 1u);
  EXPECT_TRUE(Parameters(block_net({3, 3, 3}, {2, 2, 2}), "each").one_to_one());
}

}  // namespace
}  // namespace nodal::elastic
