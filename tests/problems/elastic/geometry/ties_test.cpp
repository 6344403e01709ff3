// SPDX-License-Identifier: GPL-3.0-or-later
// Equal distances are told apart by rounding, which depends on where a body stands: the lowest node is chosen instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "../study_files.h"
#include "springs/connections.h"

namespace nodal::elastic {
namespace {

// Where a body may stand, and how large it may be: what rounding makes different.
const double kOffsets[] = {0.0, 0.1, -1.0 / 3.0, 1.7, 1234.567, -98765.4321};
const double kScales[] = {1.0, 0.1, 1.0 / 3.0, 7.3e-3, 1234.5};

std::string grid_study(std::size_t columns, std::size_t rows, double scale, double x, double y, const char* supports) {
  return fmt::format(
      "[study]\nname = \"grid\"\n[problem]\nkind = \"elastic\"\nbody = {{ corner = [{}, {}], size = [{}, {}] "
      "}}\npoints "
      "= {{ counts = [{}, {}] }}\nsprings = {{ initial = \"paper\" }}\nloads = {{ supports = \"{}\" }}\n",
      x, y, scale * static_cast<double>(columns - 1), scale * static_cast<double>(rows - 1), columns, rows, supports);
}

// The anchor of a stretch, in integers: of row numbers 0 … n−1 the lowest with the least |2 row − (n−1)|.
std::size_t middle(std::size_t count) { return (count - 1) / 2; }

TEST(Ties, AnchorsOfGridsAreTheLowestOfTheNearest) {
  for (std::size_t columns = 2; columns <= 9; ++columns)
    for (std::size_t rows = 2; rows <= 9; ++rows)
      for (const double scale : kScales)
        for (const double offset : kOffsets) {
          const double x = offset * scale, y = -0.7 * x;
          const auto plate =
              as_elastic(parse_study(grid_study(columns, rows, scale, x, y, "edge"), "grid.toml", components()));
          const LoadSet& loads = plate->scene().loads;
          const std::size_t of_x = columns * middle(rows), of_y = middle(columns);
          const auto holds = [&](std::size_t load, std::size_t node, std::size_t axis) {
            const auto& supports = loads.groups[loads.loads[load].group].supports;
            return std::ranges::count_if(supports,
                                         [&](const Support& s) { return s.axis == axis && s.node == node; }) == 1 &&
                   std::ranges::count(supports, axis, &Support::axis) == 1;
          };
          ASSERT_TRUE(holds(0, of_x, 1)) << columns << "×" << rows << " scale " << scale << " at " << x;
          ASSERT_TRUE(holds(1, of_y, 0)) << columns << "×" << rows << " scale " << scale << " at " << x;
        }
}

TEST(Ties, MinimalSupportsOfABodyMovedAreTheSameNodes) {
  for (const std::size_t sides : {4u, 5u, 6u, 8u, 12u, 33u, 64u}) {
    std::vector<std::size_t> first;
    for (const double scale : kScales)
      for (const double x : kOffsets) {
        Net net;
        net.body = plane::regular_body({x * scale, -0.7 * x * scale}, scale, sides, 0.3);
        net.nodes = lifted(net.body.rings[0]);
        find_border(net);
        const LoadSet loads = make_basic_loads(net, {}, 1.0, SupportStyle::minimal);
        std::vector<std::size_t> held;
        for (const Support& s : loads.groups[0].supports) held.push_back(2 * s.node + s.axis);
        if (first.empty()) first = held;
        EXPECT_EQ(held, first) << sides << " sides, scale " << scale << " at " << x;
      }
  }
}

// Six of eight neighbours: the four at one step, and two of the four equally far ones, by number.
TEST(Ties, NearestNodesOfAGridAreTheLowest) {
  for (const double scale : kScales)
    for (const double x : kOffsets) {
      std::vector<plane::Point> nodes;
      for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column) nodes.push_back({x + scale * column, -0.7 * x + scale * row});
      std::vector<NodePair> expected;
      for (int i = 0; i < 36; ++i) {
        std::vector<std::pair<int, int>> others;  // squared distance in steps, node
        for (int j = 0; j < 36; ++j) {
          const int dx = i % 6 - j % 6, dy = i / 6 - j / 6;
          if (i != j) others.emplace_back(dx * dx + dy * dy, j);
        }
        std::ranges::sort(others);
        for (int k = 0; k < 6; ++k) {
          const auto j = static_cast<std::size_t>(others[static_cast<std::size_t>(k)].second);
          expected.push_back(std::minmax(static_cast<std::size_t>(i), j));
        }
      }
      std::ranges::sort(expected);
      expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
      EXPECT_EQ(nearest_pairs(nullptr, nodes, 6), expected) << "scale " << scale << " at " << x;
    }
}

TEST_F(SmallSystem, EquallyNearToSeveralNodesAreTheFirst) {
  for (const double x : kOffsets) {
    write("nodes.csv", fmt::format("node,x,y\n1,{},{}\n2,{},{}\n3,{},{}\n", x, x, x + 0.2, x, x + 0.1, x + 0.3));
    write("springs.csv", "first,second\n1,2\n1,3\n2,3\n");
    write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
    const auto problem = read(fmt::format(
        "points = {{ file = \"nodes.csv\" }}\nsprings = {{ file = \"springs.csv\" }}\nreference = {{ file = "
        "\"displacements.csv\" }}\n[[problem.loads.cases]]\nname = \"load\"\nsupports = [{{ near = [{}, {}] }}, {{ "
        "nodes "
        "= [2], fix = \"y\" }}]\nforces = [{{ nodes = [3], force = [0.373, -1.431] }}]\n",
        x + 0.1, x));
    EXPECT_EQ(held_nodes(*problem), (std::vector<std::size_t>{0, 1})) << x;
    EXPECT_EQ(problem->scene().loads.groups[0].supports.size(), 3u);
    EXPECT_EQ(problem->scene().loads.groups[0].supports[1], (Support{0, 1, 0.0}));
  }
}

}  // namespace
}  // namespace nodal::elastic
