// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which of a net's nodes lie on the border of a body in the plane, and where.

#include <cstddef>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// Side i of a ring runs from its vertex i to the next. A node within outline_tolerance of a vertex is at it: on the
/// side that begins there, at 0.
struct NodeOnRing {
  std::size_t node;
  std::size_t side;
  double share;  ///< of the side
  bool corner;   ///< at a corner of the ring
};

/// The nodes on a ring of the body, along it: in time (nodes + sides) log sides.
[[nodiscard]] std::vector<NodeOnRing> nodes_on_ring(const Net& net, std::size_t ring);

}  // namespace nodal::elastic
