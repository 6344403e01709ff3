// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The nodal system: points and the springs between them (paper, section 1). Geometry only; stiffnesses are the
/// unknowns.
///
/// Units    metres.
/// Threads  plain values.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nodal/elastic/body.h>

namespace nodal::elastic {

/// Spring (i, j) with i < j: rest length L, unit direction d from i to j. b has −d at i and +d at j.
struct Spring {
  std::size_t first = 0, second = 0;
  double length = 0.0;
  Vector direction{};
};

/// The spring between two nodes.
[[nodiscard]] Spring make_spring(const std::vector<Vector>& nodes, std::size_t i, std::size_t j);

enum class NodeKind : std::uint8_t { inner, border, corner };

/// A grid that fills its rectangle or box: nodes row by row from the lower left, x fastest, then y, then z.
struct Grid {
  std::size_t columns = 0, rows = 0;  ///< nodes in x and in y; 0 when the nodes are no such grid
  Vector cell{};                      ///< size of a cell
  std::size_t layers = 1;             ///< nodes in z
};

using Triangle = std::array<std::size_t, 3>;

/// A piece of the border of a body in space, between neighbouring nodes.
struct Facet {
  std::array<std::size_t, 4> nodes{};  ///< around it
  Vector area{};                       ///< outward normal times its area [m²]
};

/// `share`: what of it counts where several triangulations of one net count together.
struct Tetrahedron {
  std::array<std::size_t, 4> nodes{};
  double share = 1.0;
};

/// Positive where the fourth node sees the others turn counterclockwise [m³].
[[nodiscard]] double volume_of(const std::vector<Vector>& nodes, const std::array<std::size_t, 4>& tetrahedron);

struct Net {
  std::size_t dimension = 2;
  Body body;
  Grid grid;
  std::string topology;  ///< what joined the nodes: "crossed", "nearest 6"; rules to start by ask for it
  std::vector<Vector> nodes;
  std::vector<Spring> springs;
  std::vector<Triangle> triangles;                 ///< counterclockwise, where springs are the sides of triangles
  std::vector<NodeKind> kinds;                     ///< [nodes]; all inner while empty
  std::vector<std::vector<std::size_t>> outlines;  ///< in the plane, per ring of the body: the nodes on it, along it
  std::vector<Facet> border;                       ///< in space: pieces of the body's surface
  std::vector<Tetrahedron> tetrahedra;             ///< in space: what springs are the edges of

  std::vector<double> masses;     ///< [nodes], kg; empty where nothing needs masses
  std::vector<std::int64_t> ids;  ///< [nodes]: what a file of the user's calls them; empty for 0, 1, 2, …

  [[nodiscard]] Freedoms freedoms() const noexcept { return {dimension, nodes.size()}; }
  /// What people call a node.
  [[nodiscard]] std::int64_t id(std::size_t node) const {
    return ids.empty() ? static_cast<std::int64_t>(node) : ids[node];
  }
  /// On the outline or on a hole's, in space on the body's surface; corners included.
  [[nodiscard]] bool on_border(std::size_t node) const { return !kinds.empty() && kinds[node] != NodeKind::inner; }
  [[nodiscard]] bool on_corner(std::size_t node) const { return !kinds.empty() && kinds[node] == NodeKind::corner; }
};

/// Fills `kinds` and `outlines` from where the nodes lie: within outline_tolerance of the body's border, or of a
/// corner. In time (nodes + sides) log sides.
void find_border(Net& net);

/// Connects a grid of nodes over a rectangle. "single": one diagonal per cell, all the same way; "alternating": one per
/// cell, chequered; "crossed": both. Refusal for another name, fewer than 2×2 nodes, or a body that is no
/// upright rectangle.
[[nodiscard]] Net make_grid_net(const Body& body, std::size_t columns, std::size_t rows, const std::string& topology);

/// Connects a grid of nodes over a box: the edges of its cells, and
///     single       per face the diagonal from the face's lowest corner, per cell that from the cell's
///     alternating  per face the diagonal from its lowest corner where that corner's i + j + k is even, else the other
///     faces        both diagonals of every face
///     crossed      these, and the four body diagonals of every cell
/// with the tetrahedra that these are edges of: Kuhn's six about each body diagonal, or the five of a chequered cell,
/// with shares that fill the box once. Nodes on faces and edges of the box are border, at its vertices corner.
/// Refusal for another name, fewer than two nodes along an axis, or a body that is no box.
[[nodiscard]] Net make_block_net(const Body& body, const std::array<std::size_t, 3>& counts,
                                 const std::string& topology);

}  // namespace nodal::elastic
