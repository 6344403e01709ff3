// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The symmetries of a net, found from its geometry: the rotations and reflections about the middle of its nodes that
/// carry nodes onto nodes and springs onto springs.
///
/// They form a finite group of the plane: m rotations by multiples of 2π/m, and none or m reflections. So the smallest
/// rotation and one reflection generate it, and only they are searched for. A node is met within 1e-9 of the net's
/// size. Candidates come from one node: it must go to a node at its own distance from the middle, and the distance is
/// chosen that fewest nodes have. Cost     candidates × nodes × log nodes at worst; nearly all candidates fail at their
/// first nodes. Threads  pure functions.

#include <cstddef>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

struct Symmetry {
  std::size_t rotations = 1;  ///< the identity included
  std::size_t reflections = 0;
  /// [generators][springs]: where the smallest rotation and one reflection, those that there are, carry each spring.
  std::vector<std::vector<std::size_t>> generators;

  [[nodiscard]] std::size_t order() const noexcept { return rotations + reflections; }
};

[[nodiscard]] Symmetry find_symmetry(const std::vector<Point>& nodes, const std::vector<Spring>& springs);

/// [springs] the lowest spring of each spring's orbit.
[[nodiscard]] std::vector<std::size_t> symmetry_classes(const Symmetry& symmetry, std::size_t springs);

}  // namespace nodal::elastic
