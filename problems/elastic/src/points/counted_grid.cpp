// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/counted_grid.h"

#include <utility>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

// The upright rectangle that a body is, as lower left and size.
std::pair<plane::Point, plane::Point> rectangle_of(const Body& body) {
  if (body.rings.size() == 1 && body.rings[0].size() == 4) {
    const plane::Ring& r = body.rings[0];
    if (r[0][1] == r[1][1] && r[1][0] == r[2][0] && r[2][1] == r[3][1] && r[3][0] == r[0][0] && r[0][0] < r[1][0] &&
        r[1][1] < r[2][1])
      return {r[0], {r[1][0] - r[0][0], r[2][1] - r[1][1]}};
  }
  throw Refusal("a grid needs a body that is an upright rectangle");
}

}  // namespace

Net place_counted_grid(const Body& body, std::size_t columns, std::size_t rows) {
  if (columns < 2 || rows < 2) throw Refusal("a grid needs at least 2 × 2 nodes");
  const auto [corner, size] = rectangle_of(body);
  Net net;
  net.body = body;
  net.grid = {
      columns, rows, {size[0] / static_cast<double>(columns - 1), size[1] / static_cast<double>(rows - 1), 0.0}};
  // Shares of the side, not sums of cells, so that the last node lies exactly on the border.
  const auto share = [](std::size_t i, std::size_t count) {
    return static_cast<double>(i) / static_cast<double>(count - 1);
  };
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      net.nodes.push_back({corner[0] + size[0] * share(column, columns), corner[1] + size[1] * share(row, rows)});
  find_border(net);
  return net;
}

}  // namespace nodal::elastic
