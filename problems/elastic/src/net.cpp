// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/net.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace nodal::elastic {

namespace {

bool rising_diagonal(const std::string& topology, std::size_t column, std::size_t row) {
  if (topology == "alternating") return (column + row) % 2 == 0;
  return true;
}

bool falling_diagonal(const std::string& topology, std::size_t column, std::size_t row) {
  return topology == "crossed" || (topology == "alternating" && (column + row) % 2 == 1);
}

bool at_end(double coordinate, double lower, double size, double tolerance) {
  return std::abs(coordinate - lower) <= tolerance || std::abs(coordinate - lower - size) <= tolerance;
}

}  // namespace

const std::vector<Topology>& topologies() {
  static const std::vector<Topology> all = {
      {"single", "one diagonal in each cell, all from lower left to upper right", false},
      {"alternating", "one diagonal in each cell, in a chequered pattern", false},
      {"crossed", "both diagonals in each cell", false},
      {"grid", "no diagonals: a mechanism, since its cells shear without resistance", true},
  };
  return all;
}

bool Net::on_border(std::size_t node) const {
  const double tolerance = 1e-9 * std::max(body.size[0], body.size[1]);
  return at_end(nodes[node][0], body.corner[0], body.size[0], tolerance) ||
         at_end(nodes[node][1], body.corner[1], body.size[1], tolerance);
}

bool Net::on_corner(std::size_t node) const {
  const double tolerance = 1e-9 * std::max(body.size[0], body.size[1]);
  return at_end(nodes[node][0], body.corner[0], body.size[0], tolerance) &&
         at_end(nodes[node][1], body.corner[1], body.size[1], tolerance);
}

Net make_grid_net(const Body& body, std::size_t columns, std::size_t rows, const std::string& topology) {
  if (columns < 2 || rows < 2) throw std::invalid_argument("a grid needs at least 2 × 2 nodes");
  const auto known = std::ranges::find(topologies(), topology, &Topology::name);
  if (known == topologies().end() || known->mechanism)
    throw std::invalid_argument("a grid can't be connected by '" + topology + "'");

  Net net;
  net.body = body;
  net.topology = topology;
  net.grid = {
      columns, rows, {body.size[0] / static_cast<double>(columns - 1), body.size[1] / static_cast<double>(rows - 1)}};
  // Shares of the side, not sums of cells, so that the last node lies exactly on the border.
  const auto share = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
  };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      net.nodes.push_back(
          {body.corner[0] + body.size[0] * share(column, columns), body.corner[1] + body.size[1] * share(row, rows)});

  const auto connect = [&net](std::size_t i, std::size_t j) {
    const Point d = {net.nodes[j][0] - net.nodes[i][0], net.nodes[j][1] - net.nodes[i][1]};
    const double length = std::hypot(d[0], d[1]);
    net.springs.push_back({i, j, length, {d[0] / length, d[1] / length}});
  };
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
