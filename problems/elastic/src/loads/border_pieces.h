// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What pulls at a body's border, as forces on its nodes.
///
/// Shapes   forces: [freedoms].
/// Units    Pa, N.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <nodal/elastic/material.h>
#include <nodal/elastic/net.h>

#include "loads/stress_field.h"

namespace nodal::elastic {

/// The border between neighbouring nodes on it: two on an outline, in its direction, or the corners of a cell's face.
struct BorderPiece {
  std::span<const std::size_t> nodes;
  Vector area{};         ///< outward normal, times the length in the plane, the area in space
  double share = 0.0;    ///< of σ·area that each node gets: in the plane half the thickness
  std::size_t ring = 0;  ///< of the body, on which it lies

  /// All of its nodes are among these, which ascend.
  [[nodiscard]] bool within(const std::vector<std::size_t>& ascending) const;
};

/// Calls `visit` for every pair of neighbours on every outline, the closing one too, and in space for every facet. A
/// ring with fewer than two nodes has none; one with two has both ways between them.
void for_each_border_piece(const Net& net, const std::function<void(const BorderPiece&)>& visit);

/// Adds what σ·n pulls with at one piece.
void add_stress(const Net& net, const BorderPiece& piece, const Tensor& stress, std::span<double> forces);

/// Adds what the part of a stress that grows by `gradient` from `centre` pulls with at one piece. The traction is
/// linear along a segment, a triangle and a rectangle; nodes get what does the same work on displacements that are,
/// too:
///     f_i = Σ_j M_ij σ(x_j)·area,  M = [2 1; 1 2]/6, [2 1 1; …]/12, [4 2 1 2; …]/36 around the rectangle.
/// So forces and torques around a closed border balance wherever the stress is in equilibrium.
void add_stress_growth(const Net& net, const BorderPiece& piece, const StressGradient& gradient, const Vector& centre,
                       std::span<double> forces);

/// Of an axis: left and right of 0, bottom and top of 1.
enum class End { low, high };
/// The nodes on a side of the body's bounding box, ascending: in the plane those of the outline.
[[nodiscard]] std::vector<std::size_t> side_nodes(const Net& net, std::size_t axis, End end);

}  // namespace nodal::elastic
