// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The symmetries of a net, found from its geometry: the rotations and reflections about the middle of its nodes that
/// carry nodes onto nodes and springs onto springs.
///
/// In the plane they form a finite group: m rotations by multiples of 2π/m, and none or m reflections. So the smallest
/// rotation and one reflection generate it, and only they are searched for; in space all are. A node is met within 1e-9
/// of the net's size. Candidates come from one node, in space from two: it must go to a node at its own distance from
/// the middle, and the distance is chosen that fewest nodes have.
///
/// Cost     candidates × nodes × log nodes at worst; nearly all candidates fail at their first nodes.
/// Threads  pure functions.

#include <cstddef>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

struct Symmetry {
  std::size_t rotations = 1;  ///< the identity included
  std::size_t reflections = 0;
  /// [generators][springs]: where symmetries that generate all carry each spring; the identity isn't among them.
  std::vector<std::vector<std::size_t>> generators;

  [[nodiscard]] std::size_t order() const noexcept { return rotations + reflections; }
};

[[nodiscard]] Symmetry find_symmetry(std::size_t dimension, const std::vector<Vector>& nodes,
                                     const std::vector<Spring>& springs);

/// [springs] the lowest spring of each spring's orbit.
[[nodiscard]] std::vector<std::size_t> symmetry_classes(const Symmetry& symmetry, std::size_t springs);

}  // namespace nodal::elastic
