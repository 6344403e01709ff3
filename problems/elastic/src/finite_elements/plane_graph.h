// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The rings and interfaces of a plane body as a graph: places, and straight pieces that meet nowhere but in places.
///
/// What rounding leaves apart is brought together here, so that a mesh has no reason for triangles as small as
/// rounding: an interface's end or crossing within the tolerance of another place is that place, and pieces along a
/// ring's side, outside of the body or given twice are left out. Rings don't move.
///
/// Cost     the number of interfaces times that of rings' sides and interfaces.

#include <array>
#include <cstddef>
#include <vector>

#include "finite_elements/plane_mesh.h"

namespace nodal::elastic::finite_elements {

struct PlaneGraph {
  using Piece = std::array<std::size_t, 2>;  // from place to place

  std::vector<plane::Point> places;  ///< first the rings' vertices, ring by ring, then further ones
  std::vector<Piece> border;         ///< pieces of the rings' sides, in their sense: material to the left
  std::vector<std::size_t> label;    ///< [border]
  std::vector<Piece> interfaces;
};

[[nodiscard]] PlaneGraph plane_graph(const PlaneBody& body);

/// Within the rings, by even and odd crossings of a ray.
[[nodiscard]] bool within(const std::vector<LabelledRing>& rings, const plane::Point& point);

/// The size of a body's bounding box.
[[nodiscard]] double size_of(const PlaneBody& body);

}  // namespace nodal::elastic::finite_elements
