// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <nodal/elastic/parameters.h>
#include <nodal/error.h>
#include <nodal/random.h>

#include "parameters/spring_classes.h"
#include "parameters/symmetry.h"

namespace nodal::elastic {
namespace {

using std::numbers::pi;

Net net_of(std::vector<plane::Point> nodes, const std::vector<std::array<std::size_t, 2>>& pairs) {
  Net net;
  net.topology = "test";
  net.nodes = lifted(nodes);
  for (const auto& [i, j] : pairs) net.springs.push_back(make_spring(net.nodes, i, j));
  return net;
}

// Springs between all nodes that are no farther apart than `reach`.
Net joined_within(std::vector<plane::Point> nodes, double reach) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = i + 1; j < nodes.size(); ++j)
      if (std::hypot(nodes[i][0] - nodes[j][0], nodes[i][1] - nodes[j][1]) <= reach) pairs.push_back({i, j});
  return net_of(std::move(nodes), pairs);
}

// A hexagon of `rings` rings of unit triangles about its middle node: 1 + 3 rings (rings + 1) nodes.
Net hexagon(int rings) {
  std::vector<plane::Point> nodes;
  for (int a = -rings; a <= rings; ++a)
    for (int b = -rings; b <= rings; ++b)
      if (std::abs(a + b) <= rings) nodes.push_back({a + 0.5 * b, 0.5 * std::sqrt(3.0) * b});
  return joined_within(nodes, 1.01);
}

Net crossed(std::size_t columns, std::size_t rows, const char* topology = "crossed") {
  return make_grid_net(plane::rectangle_body({0, 0}, {static_cast<double>(columns - 1), static_cast<double>(rows - 1)}),
                       columns, rows, topology);
}

Net random_net(std::size_t count, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<plane::Point> nodes(count);
  for (plane::Point& p : nodes) p = {random.uniform(), random.uniform()};
  return joined_within(nodes, 2.0 / std::sqrt(static_cast<double>(count)));
}

Net turned(Net net, double angle, const plane::Point& by, double scale = 1.0) {
  for (Vector& p : net.nodes)
    p = {by[0] + scale * (std::cos(angle) * p[0] - std::sin(angle) * p[1]),
         by[1] + scale * (std::sin(angle) * p[0] + std::cos(angle) * p[1]), 0.0};
  for (Spring& s : net.springs) s = make_spring(net.nodes, s.first, s.second);
  net.grid = {};
  return net;
}

std::vector<std::size_t> groups(const Net& net, const ParameterRule& rule) {
  const Parameters parameters(net, rule);
  std::vector<std::size_t> of;
  for (std::size_t e = 0; e < net.springs.size(); ++e) of.push_back(parameters.coordinate_of(e));
  return of;
}

std::vector<std::string> names(const Net& net, const ParameterRule& rule) {
  const Parameters parameters(net, rule);
  std::vector<std::string> all;
  for (std::size_t g = 0; g < parameters.size(); ++g) all.push_back(parameters.name(g));
  return all;
}

std::string refusal(const Net& net, const ParameterRule& rule) {
  try {
    const Parameters parameters(net, rule);
  } catch (const Refusal& error) {
    return error.what();
  }
  return "accepted";
}

std::size_t order(const Net& net) { return find_symmetry(2, net.nodes, net.springs).order(); }

// ── symmetric ───────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Symmetry, IsThatOfTheFigure) {
  EXPECT_EQ(order(hexagon(1)), 12u);
  EXPECT_EQ(order(hexagon(4)), 12u);
  EXPECT_EQ(order(crossed(5, 5)), 8u);
  EXPECT_EQ(order(crossed(2, 2)), 8u);
  EXPECT_EQ(order(crossed(6, 4)), 4u);
  EXPECT_EQ(order(crossed(5, 5, "single")), 4u);  // half a turn and both diagonals
  EXPECT_EQ(order(crossed(6, 4, "single")), 2u);  // half a turn
  for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_EQ(order(random_net(60, seed)), 1u);
}

// The nodes alone aren't enough: one spring less, and only what leaves its place is left.
TEST(Symmetry, IsOfNodesAndSprings) {
  Net net = hexagon(2);
  const auto middle = [&](const Spring& s) {
    return std::hypot(net.nodes[s.first][0] + net.nodes[s.second][0], net.nodes[s.first][1] + net.nodes[s.second][1]);
  };
  const auto spoke = std::ranges::min_element(net.springs, {}, middle);
  net.springs.erase(spoke);
  EXPECT_EQ(order(net), 2u);
}

// A ring whose spokes lean: all turns, no reflection. Every distance occurs as often as there are turns.
TEST(Symmetry, CanBeOfTurnsOnly) {
  constexpr std::size_t n = 9;
  std::vector<plane::Point> nodes;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < n; ++i) nodes.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)});
  for (std::size_t i = 0; i < n; ++i) nodes.push_back({2 * std::cos(2 * pi * i / n), 2 * std::sin(2 * pi * i / n)});
  for (std::size_t i = 0; i < n; ++i) {
    pairs.push_back({i, (i + 1) % n});
    pairs.push_back({n + i, n + (i + 1) % n});
    pairs.push_back({i, n + (i + 1) % n});
  }
  const Net net = net_of(nodes, pairs);
  const Symmetry symmetry = find_symmetry(2, net.nodes, net.springs);
  EXPECT_EQ(symmetry.rotations, 9u);
  EXPECT_EQ(symmetry.reflections, 0u);
  EXPECT_EQ(Parameters(net, "symmetric").size(), 3u);
  EXPECT_EQ(Parameters(net, "symmetric").largest_group(), 9u);
}

TEST(Symmetry, IsLostByAMoveBeyondItsTolerance) {
  Net near = crossed(5, 5), far = near;
  near.nodes[0][0] += 1e-11;
  far.nodes[0][0] += 1e-6;
  EXPECT_EQ(order(near), 8u);
  EXPECT_EQ(order(far), 1u);
  far.nodes[0][1] += 1e-6;  // along the diagonal, whose reflection stays
  EXPECT_EQ(order(far), 2u);
}

TEST(Symmetry, DependsNeitherOnPlaceNorOnDirectionNorOnSize) {
  for (const Net& net : {hexagon(3), crossed(5, 5), crossed(4, 6, "alternating")})
    for (const double angle : {0.0, 0.3, 1.0, 2.5})
      for (const plane::Point& by : {plane::Point{0, 0}, plane::Point{1e5, -2e5}})
        for (const double scale : {1.0, 1e3}) {
          const Net moved = turned(net, angle, by, scale);
          EXPECT_EQ(order(moved), order(net));
          EXPECT_EQ(groups(moved, "symmetric"), groups(net, "symmetric"));
        }
}

// On grids: what the plate's reflections, written out on row and column, make of it.
TEST(Symmetry, OfGridsIsThatOfTheirRowsAndColumns) {
  for (const auto& counts : {std::array<std::size_t, 2>{5, 5}, {4, 4}, {7, 3}, {2, 6}}) {
    const std::size_t columns = counts[0], rows = counts[1];
    const Net net = crossed(columns, rows);
    std::map<std::array<std::size_t, 4>, std::size_t> group_of;  // by the lowest image of a spring's ends
    const std::vector<std::size_t> group = groups(net, "symmetric");
    for (std::size_t e = 0; e < net.springs.size(); ++e) {
      std::array<std::size_t, 4> lowest = {columns, rows, columns, rows};
      for (int flip = 0; flip < (columns == rows ? 8 : 4); ++flip) {
        const auto image = [&](std::size_t node) {
          std::array<std::size_t, 2> at = {node % columns, node / columns};
          if (flip & 1) at[0] = columns - 1 - at[0];
          if (flip & 2) at[1] = rows - 1 - at[1];
          if (flip & 4) std::swap(at[0], at[1]);
          return at;
        };
        const auto [p, q] = std::minmax({image(net.springs[e].first), image(net.springs[e].second)});
        lowest = std::min(lowest, {p[0], p[1], q[0], q[1]});
      }
      const auto [entry, fresh] = group_of.emplace(lowest, group[e]);
      EXPECT_EQ(entry->second, group[e]) << "spring " << e;
      EXPECT_EQ(fresh, std::ranges::find(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(e), group[e]) ==
                           group.begin() + static_cast<std::ptrdiff_t>(e));
    }
  }
  EXPECT_EQ(names(crossed(2, 2), "symmetric"), (std::vector<std::string>{"ln k(0,1)", "ln k(0,3)"}));
}

TEST(Symmetry, IsFoundInNetsOfThousandsOfNodes) {
  const Net large = hexagon(25);  // 1,951 nodes
  EXPECT_EQ(large.nodes.size(), 1951u);
  EXPECT_EQ(order(large), 12u);
  // Every node at the same distance: nothing is rare, and all turns hold.
  std::vector<plane::Point> ring;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (std::size_t i = 0; i < 2000; ++i) ring.push_back({std::cos(2 * pi * i / 2000), std::sin(2 * pi * i / 2000)});
  for (std::size_t i = 0; i < 2000; ++i) pairs.push_back({i, (i + 1) % 2000});
  EXPECT_EQ(order(net_of(ring, pairs)), 4000u);
}

TEST(Symmetry, IsRefusedWhereThereIsNone) {
  EXPECT_EQ(
      refusal(random_net(30, 1), "symmetric"),
      "the 'test' net of 30 nodes has no symmetry: no rotation or reflection about the middle of its nodes carries "
      "nodes and springs onto nodes and springs");
}

// ── by direction ────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Directions, AreThreeInANetOfTriangles) {
  EXPECT_EQ(Parameters(hexagon(3), "by-direction").size(), 3u);
  const std::set<std::string> expected = {"ln k 0°", "ln k 60°", "ln k 120°"};
  const std::vector<std::string> found = names(hexagon(3), "by-direction");
  EXPECT_EQ(std::set<std::string>(found.begin(), found.end()), expected);
}

TEST(Directions, KeepTheirNamesOnGrids) {
  EXPECT_EQ(names(crossed(4, 3), "by-direction"),
            (std::vector<std::string>{"ln k horizontal", "ln k vertical", "ln k diagonal"}));
  Net free = crossed(4, 3);
  free.grid = {};  // the same springs as a net of any kind: its two diagonals are two directions
  EXPECT_EQ(Parameters(free, "by-direction").size(), 4u);
}

TEST(Directions, OfOneClassDifferByNoMoreThanTheTolerance) {
  for (const double tolerance : {1.0, 10.0, 45.0, 90.0}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Net net = random_net(50, seed);
      ParameterRule rule("by-direction");
      rule.direction_tolerance = tolerance;
      const Parameters parameters(net, rule);
      EXPECT_GE(static_cast<double>(parameters.size()), tolerance == 1.0 ? 90.0 : 180.0 / tolerance);
      for (std::size_t g = 0; g < parameters.size(); ++g)
        for (const std::size_t a : parameters.springs_of(g))
          for (const std::size_t b : parameters.springs_of(g)) {
            const Vector &p = net.springs[a].direction, &q = net.springs[b].direction;
            const double between = std::asin(std::min(1.0, std::abs(p[0] * q[1] - p[1] * q[0]))) * 180.0 / pi;
            EXPECT_LE(between, tolerance + 1e-6);
          }
    }
  }
}

TEST(Directions, MakeTheSameClassesOfATurnedNet) {
  for (const Net& net : {hexagon(3), random_net(40, 3), random_net(12, 8)})
    for (const double angle : {0.2, 0.9, 2.2, 3.0}) {
      for (const double tolerance : {0.5, 10.0}) {
        ParameterRule rule("by-direction");
        rule.direction_tolerance = tolerance;
        EXPECT_EQ(groups(turned(net, angle, {3, -4}), rule), groups(net, rule)) << angle;
      }
    }
}

// A bundle about 0° = 180°, which a cut at 0 would split.
TEST(Directions, AreOnACircle) {
  const Net net = net_of({{0, 0}, {1, 0.02}, {1, -0.02}, {0, 1}}, {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(groups(net, "by-direction"), (std::vector<std::size_t>{0, 0, 1}));
  EXPECT_EQ(names(net, "by-direction")[1], "ln k 90°");
}

// ── by length ───────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Lengths, AreNeverSeparatedWhenEqual) {
  EXPECT_EQ(names(crossed(5, 5), "by-length"), (std::vector<std::string>{"ln k 1 m", "ln k 1.414 m"}));
  EXPECT_EQ(Parameters(turned(crossed(5, 5), 0.4, {1, 1}), "by-length").size(), 2u);
  EXPECT_EQ(Parameters(hexagon(3), "by-length").size(), 1u);
}

TEST(Lengths, AreDividedWhereTheyLeaveGaps) {
  const std::vector<double> lengths = {1.0, 1.1, 5.0, 1.05, 5.2, 30.0};
  std::vector<Spring> springs;
  for (const double length : lengths) springs.push_back({0, 1, length, {1, 0}});
  const SpringClasses classes = classes_by_length(springs, 3);
  EXPECT_EQ(classes.of, (std::vector<std::size_t>{0, 0, 1, 0, 1, 2}));
  EXPECT_EQ(classes.names, (std::vector<std::string>{"1 m–1.1 m", "5 m–5.2 m", "30 m"}));
  EXPECT_EQ(classes_by_length(springs, 6).names.size(), 6u);
  EXPECT_EQ(classes_by_length(springs, 9).names.size(), 6u);
  EXPECT_EQ(classes_by_length(springs, 1).names.size(), 1u);
}

// Against all divisions of a few lengths.
TEST(Lengths, AreDividedWithTheLeastDeviation) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed);
    std::vector<double> x(12);
    for (double& value : x) value = random.uniform(0.0, 3.0);
    std::ranges::sort(x);
    const auto deviation = [&](std::size_t from, std::size_t to) {
      double mean = 0.0, sum = 0.0;
      for (std::size_t i = from; i < to; ++i) mean += x[i] / static_cast<double>(to - from);
      for (std::size_t i = from; i < to; ++i) sum += (x[i] - mean) * (x[i] - mean);
      return sum;
    };
    double best = 1e300;
    for (std::size_t a = 1; a < 12; ++a)
      for (std::size_t b = a + 1; b < 12; ++b)
        for (std::size_t c = b + 1; c < 12; ++c)
          best = std::min(best, deviation(0, a) + deviation(a, b) + deviation(b, c) + deviation(c, 12));
    std::vector<Spring> springs;
    for (const double value : x) springs.push_back({0, 1, std::exp(value), {1, 0}});
    const SpringClasses classes = classes_by_length(springs, 4);
    ASSERT_EQ(classes.names.size(), 4u);
    double found = 0.0;
    for (std::size_t from = 0, to = 0; from < 12; from = to) {
      while (to < 12 && classes.of[to] == classes.of[from]) ++to;
      found += deviation(from, to);
    }
    EXPECT_NEAR(found, best, 1e-12);
  }
}

// ── lists ───────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Groups, AreThoseThatAreListed) {
  const Net net = crossed(2, 2);  // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
  const ParameterRule rule = listed_rule(net, {{"edges", {{1, 0}, {2, 3}}}, {"cross", {{0, 3}, {1, 2}}}});
  EXPECT_EQ(groups(net, rule), (std::vector<std::size_t>{0, 1, 2, 2, 3, 0}));
  EXPECT_EQ(names(net, rule), (std::vector<std::string>{"ln k edges", "ln k(0,2)", "ln k cross", "ln k(1,3)"}));
}

TEST(Groups, AreRefusedWhereTheyFitNoSpring) {
  const Net net = crossed(3, 2);
  const auto refused = [&](const std::vector<SpringGroup>& list) -> std::string {
    try {
      (void)listed_rule(net, list);
    } catch (const Refusal& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused({{"a", {{0, 2}}}}), "group 'a' lists (0, 2), but no spring joins these nodes");
  EXPECT_EQ(refused({{"a", {{0, 1}}}, {"b", {{1, 0}}}}),
            "spring (1, 0) is in the groups 'a' and 'b'; it can be in one");
  EXPECT_EQ(refused({{"a", {{0, 1}, {1, 0}}}}), "group 'a' lists (1, 0) twice");
  EXPECT_EQ(refused({{"a", {}}}), "group 'a' has no springs");
  EXPECT_EQ(refused({{"", {{0, 1}}}}), "a group of springs needs a name");
  EXPECT_EQ(refused({{"a", {{0, 1}}}, {"a", {{1, 2}}}}), "two groups are named 'a'");
  EXPECT_EQ(refusal(net, "listed"), "0 groups are listed for 11 springs; give one per spring");
}

TEST(Rules, RefuseOptionsOutOfRange) {
  ParameterRule wide("by-direction"), none("by-length");
  wide.direction_tolerance = 91.0;
  none.length_classes = 0;
  EXPECT_EQ(refusal(hexagon(1), wide), "a tolerance of 91° is no tolerance of directions; it must be from 0 to 90");
  EXPECT_EQ(refusal(hexagon(1), none), "0 classes of length leave springs without one; give ≥ 1");
  EXPECT_EQ(refusal(hexagon(1), "by-colour"), "unknown rule of parameters 'by-colour'");
}

}  // namespace
}  // namespace nodal::elastic
