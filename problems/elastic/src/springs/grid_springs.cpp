// SPDX-License-Identifier: GPL-3.0-or-later
#include "springs/grid_springs.h"

#include <algorithm>
#include <array>

#include <nodal/error.h>

#include "points/counted_grid.h"

namespace nodal::elastic {

namespace {

bool rising_diagonal(std::string_view topology, std::size_t column, std::size_t row) {
  if (topology == "alternating") return (column + row) % 2 == 0;
  return true;
}

bool falling_diagonal(std::string_view topology, std::size_t column, std::size_t row) {
  return topology == "crossed" || (topology == "alternating" && (column + row) % 2 == 1);
}

}  // namespace

void join_counted_grid(Net& net, std::string_view topology) {
  constexpr std::array<std::string_view, 3> kOfGrids = {"single", "alternating", "crossed"};
  if (std::ranges::find(kOfGrids, topology) == kOfGrids.end())
    throw Refusal("a grid can't be connected by '" + std::string(topology) + "'");
  net.topology = topology;
  const std::size_t columns = net.grid.columns, rows = net.grid.rows;
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
}

Net make_grid_net(const Body& body, std::size_t columns, std::size_t rows, const std::string& topology) {
  Net net = place_counted_grid(body, columns, rows);
  join_counted_grid(net, topology);
  return net;
}

}  // namespace nodal::elastic
