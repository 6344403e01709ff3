// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes of an upright box in space: planes across each axis, and in each cell between them Kuhn's six tetrahedra,
/// which share their cell's diagonal and fit to those of the neighbours.
///
/// Units    metres.
/// Errors   Refusal for a mesh of more than `cell_limit` tetrahedra.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "finite_elements/mesh.h"

namespace nodal::elastic::finite_elements {

/// Labels of the sides: 0 at low x, 1 at high x, 2 at low y, … 5 at high z.
[[nodiscard]] constexpr std::size_t face_label(std::size_t axis, bool high) { return 2 * axis + (high ? 1 : 0); }

struct Block {
  Extent box;
  /// Coordinates that planes must have: faces of regions, places that are held. Those outside are left out, and those
  /// within 1e-9 of the box's size of another are that one.
  std::array<std::vector<double>, 3> planes = {};
  /// Coordinates towards which planes get closer, and have one: edges of a clamped face, faces of regions.
  std::array<std::vector<double>, 3> graded = {};
  std::function<std::size_t(const Vector&)> region = {};  ///< of a cell's centre; 0 everywhere without it
  std::size_t cell_limit = 1'000'000;                     ///< tetrahedra
};

/// The planes across an axis, ascending: between neighbours of those given as many as make no gap longer than
/// `spacing`, at equal steps of t, where x = a + (b − a) t² towards a graded a, and so from both ends to the middle
/// where both are graded.
[[nodiscard]] std::vector<double> planes_across(const Block& block, std::size_t axis, double spacing);

[[nodiscard]] Mesh block_mesh(const Block& block, double spacing);

}  // namespace nodal::elastic::finite_elements
