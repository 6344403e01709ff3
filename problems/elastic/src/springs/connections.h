// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which nodes are joined by springs, where no grid says it.
///
/// delaunay            the sides of the triangles
/// delaunay-flip       and for every inner side the segment between the opposite corners of its two triangles, where
///                     they make a convex quadrilateral: about 6 springs per node instead of 3, so the patch test at a
///                     node (Σ k L d⊗d⊗d = 0, 4 equations) has room to hold
/// voronoi-neighbours  the sides whose two Voronoi regions touch inside the body
/// nearest             each node with its k nearest, except across the outline
///
/// Pairs are sorted, first < second, each once.

#include <cstddef>
#include <utility>
#include <vector>

#include <nodal/elastic/net.h>

#include "geometry/plane/outline.h"

namespace nodal::elastic {

using NodePair = std::pair<std::size_t, std::size_t>;

/// A side of triangles, with the corners that lie opposite to it: one on a border, two inside.
struct TriangleSide {
  NodePair ends;
  std::vector<std::size_t> opposite;
};
[[nodiscard]] std::vector<TriangleSide> sides_of(const std::vector<Triangle>& triangles);

/// Takes off, from outside in, triangles whose longest side is on the border and whose height over it is less than
/// `least_height` of it: nodes that lie on a line up to rounding make them, and their springs would hold next to
/// nothing. Returns how many.
std::size_t drop_slivers(const std::vector<plane::Point>& nodes, std::vector<Triangle>& triangles, double least_height);
inline constexpr double kLeastTriangleHeight = 1e-3;

[[nodiscard]] std::vector<NodePair> side_pairs(const std::vector<Triangle>& triangles);
[[nodiscard]] std::vector<NodePair> flip_pairs(const std::vector<plane::Point>& nodes,
                                               const std::vector<Triangle>& triangles);
/// Without an outline nothing stands between nodes. In time n log n.
[[nodiscard]] std::vector<NodePair> nearest_pairs(const plane::Outline* outline, const std::vector<plane::Point>& nodes,
                                                  std::size_t count);

}  // namespace nodal::elastic
