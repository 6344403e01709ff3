// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The border of a body in the plane with a net's nodes as vertices of it: so that what a net's pieces of the border
/// bear is borne by whole sides of a mesh, and what a node holds is held by a vertex.

#include <cstddef>
#include <limits>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// The label of a side that is no net's piece: of a ring with fewer than two nodes.
inline constexpr std::size_t kNoPiece = std::numeric_limits<std::size_t>::max();

struct MarkedBorder {
  std::vector<plane::Ring> rings;  ///< as the body's
  std::vector<std::vector<std::size_t>>
      pieces;                       ///< [rings][sides] which one of for_each_border_piece a side is part of
  std::vector<plane::Point> place;  ///< [nodes] of those on the border, as a vertex; else the node's own
};

[[nodiscard]] MarkedBorder mark_border(const Net& net);

}  // namespace nodal::elastic
