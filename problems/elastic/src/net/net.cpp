// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/net.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <nodal/error.h>

#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

bool rising_diagonal(const std::string& topology, std::size_t column, std::size_t row) {
  if (topology == "alternating") return (column + row) % 2 == 0;
  return true;
}

bool falling_diagonal(const std::string& topology, std::size_t column, std::size_t row) {
  return topology == "crossed" || (topology == "alternating" && (column + row) % 2 == 1);
}

// The upright rectangle that a body is, as lower left and size.
std::pair<Point, Point> rectangle_of(const Body& body) {
  if (body.rings.size() == 1 && body.rings[0].size() == 4) {
    const Ring& r = body.rings[0];
    if (r[0][1] == r[1][1] && r[1][0] == r[2][0] && r[2][1] == r[3][1] && r[3][0] == r[0][0] && r[0][0] < r[1][0] &&
        r[1][1] < r[2][1])
      return {r[0], {r[1][0] - r[0][0], r[2][1] - r[1][1]}};
  }
  throw Refusal("a grid needs a body that is an upright rectangle");
}

}  // namespace

const std::vector<Topology>& topologies() {
  const std::string lacks = triangulation_available() ? "" : triangulation_library();
  static const std::vector<Topology> all = {
      {"single", "one diagonal in each cell, all from lower left to upper right", false},
      {"alternating", "one diagonal in each cell, in a chequered pattern", false},
      {"crossed", "both diagonals in each cell", false},
      {"grid", "no diagonals: a mechanism, since its cells shear without resistance", true},
      {"triangular", "the three directions of a triangular grid", false},
      {"delaunay", "the sides of the Delaunay triangles in the body", false, lacks},
      {"delaunay-flip", "and across every inner side, between the opposite corners: about 6 springs per node", false,
       lacks},
      {"voronoi-neighbours", "nodes whose Voronoi regions touch inside the body", false, lacks},
      {"nearest", "each node with its nearest ones, except across the outline", false},
  };
  return all;
}

Spring make_spring(const std::vector<Point>& nodes, std::size_t i, std::size_t j) {
  const std::size_t first = std::min(i, j), second = std::max(i, j);
  const Point d = {nodes[second][0] - nodes[first][0], nodes[second][1] - nodes[first][1]};
  const double length = std::hypot(d[0], d[1]);
  return {first, second, length, {d[0] / length, d[1] / length}};
}

Net make_grid_net(const Body& body, std::size_t columns, std::size_t rows, const std::string& topology) {
  if (columns < 2 || rows < 2) throw Refusal("a grid needs at least 2 × 2 nodes");
  constexpr std::array<const char*, 3> of_grids = {"single", "alternating", "crossed"};
  if (std::ranges::find(of_grids, topology) == of_grids.end())
    throw Refusal("a grid can't be connected by '" + topology + "'");

  const auto [corner, size] = rectangle_of(body);
  Net net;
  net.body = body;
  net.topology = topology;
  net.layout = fmt::format("grid of {} × {} nodes", columns, rows);
  net.grid = {columns, rows, {size[0] / static_cast<double>(columns - 1), size[1] / static_cast<double>(rows - 1)}};
  // Shares of the side, not sums of cells, so that the last node lies exactly on the border.
  const auto share = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
  };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      net.nodes.push_back({corner[0] + size[0] * share(column, columns), corner[1] + size[1] * share(row, rows)});
  find_border(net);

  const auto connect = [&net](std::size_t i, std::size_t j) { net.springs.push_back(make_spring(net.nodes, i, j)); };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t node = row * columns + column;
      if (column + 1 < columns) connect(node, node + 1);
      if (row + 1 == rows) continue;
      if (column > 0 && falling_diagonal(topology, column - 1, row)) connect(node, node + columns - 1);
      connect(node, node + columns);
      if (column + 1 < columns && rising_diagonal(topology, column, row)) connect(node, node + columns + 1);
    }
  }
  return net;
}

}  // namespace nodal::elastic
