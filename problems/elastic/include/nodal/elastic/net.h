// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The nodal system: points and the springs between them (paper, section 1). Geometry only; stiffnesses are the
/// unknowns.
///
/// Grid nodes are numbered row by row from the lower left, x fastest.
/// Units    metres.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace nodal::elastic {

using Point = std::array<double, 2>;

/// The rectangle that is approximated.
struct Body {
  Point corner = {0.0, 0.0};  ///< lower left
  Point size = {1.0, 1.0};
  double thickness = 1.0;
};

/// Spring (i, j) with i < j: rest length L, unit direction d from i to j. b has −d at i and +d at j.
struct Spring {
  std::size_t first = 0, second = 0;
  double length = 0.0;
  Point direction = {0.0, 0.0};
};

struct Grid {
  std::size_t columns = 0, rows = 0;  ///< nodes in x and in y
  Point cell = {0.0, 0.0};            ///< size of a cell
};

struct Net {
  Body body;
  Grid grid;
  std::string topology;
  std::vector<Point> nodes;
  std::vector<Spring> springs;

  /// Within 1e-9 of the body's size of its border / of a corner.
  [[nodiscard]] bool on_border(std::size_t node) const;
  [[nodiscard]] bool on_corner(std::size_t node) const;
};

/// Names of the topologies that a grid can be connected by, with one line each; `grid` is listed as a mechanism.
struct Topology {
  std::string name;
  std::string summary;
  bool mechanism = false;
};
[[nodiscard]] const std::vector<Topology>& topologies();

/// Connects a grid of nodes over the body. "single": one diagonal per cell, all the same way; "alternating": one per
/// cell, chequered; "crossed": both. std::invalid_argument for another name or fewer than 2×2 nodes.
[[nodiscard]] Net make_grid_net(const Body& body, std::size_t columns, std::size_t rows, const std::string& topology);

}  // namespace nodal::elastic
