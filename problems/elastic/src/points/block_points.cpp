// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/block_points.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

// The surface, a quad per outer face of a cell.
void add_border(const Block& block, Net& net) {
  const Vector size = block.cell();
  block.for_each_cell([&](const BlockIndex& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
      for (const std::ptrdiff_t end : {std::ptrdiff_t{0}, std::ptrdiff_t{1}}) {
        if (cell[axis] != (end == 0 ? 0 : block.count(axis) - 2)) continue;
        const unsigned at = end == 0 ? 0u : 1u << axis;
        Facet facet;
        std::size_t corner = 0;
        for (const unsigned around : {0u, 1u << p, 1u << p | 1u << q, 1u << q})
          facet.nodes[corner++] = block.node(corner_of(cell, at | around));
        facet.area[axis] = (end == 0 ? -1.0 : 1.0) * size[p] * size[q];
        net.border.push_back(facet);
      }
    }
  });
}

// As thin a box may be (box_body), in ten layers: thinner cells are beyond double precision for the same reason.
constexpr double kThinnestCell = 1e-7;

void require_thick_cells(const Vector& cell) {
  const auto [thin, longest] = std::ranges::minmax(cell);
  if (thin < kThinnestCell * longest)
    throw Refusal(
        fmt::format("cells of {:.6g} m are too thin to be computed with; each side must be at least {} of the "
                    "longest: take fewer nodes where they are thin",
                    fmt::join(cell, " × "), kThinnestCell));
}

}  // namespace

Net place_block(const Body& body, const std::array<std::size_t, 3>& counts) {
  if (!body.box) throw Refusal("a block of nodes needs a body that is a box");
  if (*std::ranges::min_element(counts) < 2) throw Refusal("a block needs at least 2 × 2 × 2 nodes");
  const Block block(*body.box, counts);
  require_thick_cells(block.cell());
  Net net;
  net.dimension = 3;
  net.body = body;
  net.grid = {counts[0], counts[1], block.cell(), counts[2]};
  block.for_each_node([&](const BlockIndex& i) {
    net.nodes.push_back(block.place(i));
    net.kinds.push_back(block.kind(i));
  });
  add_border(block, net);
  return net;
}

}  // namespace nodal::elastic
