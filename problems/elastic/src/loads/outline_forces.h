// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What pulls at an outline, as forces on its nodes.
///
/// Shapes   forces: [2 · nodes]. Units    Pa, N.

#include <array>
#include <functional>
#include <span>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// A stress state (σ_xx, σ_yy, σ_xy).
using Stress = std::array<double, 3>;

/// Two neighbours on one outline, in its direction.
struct OutlinePiece {
  std::size_t ring = 0, from = 0, to = 0;
};

/// Calls `visit` for every pair of neighbours on every outline, the closing one too. A ring with fewer than two nodes
/// has none; one with two has both ways between them.
void for_each_outline_piece(const Net& net, const std::function<void(const OutlinePiece&)>& visit);

/// Adds t σ·n ds of one piece: half to each node.
void add_stress(const Net& net, const OutlinePiece& piece, const Stress& stress, std::span<double> forces);

/// The nodes on a side of the outline's bounding box, ascending along it: axis 0 is left and right, 1 bottom and top.
enum class End { low, high };
[[nodiscard]] std::vector<std::size_t> box_side_nodes(const Net& net, std::size_t axis, End end);

}  // namespace nodal::elastic
