// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stresses at nodes: those of the cells around a node, averaged by their size, never across regions.
///
/// A quadratic element's stress is linear and jumps between cells; averaged it is O(h²). Exact where the stress is
/// linear.
///
/// Units    Pa.

#include <cstddef>
#include <vector>

#include <nodal/elastic/material.h>

#include "finite_elements/locator.h"
#include "finite_elements/problem.h"

namespace nodal::elastic::finite_elements {

/// A node on an interface has one value per region.
struct NodalStress {
  std::vector<std::size_t> index;  ///< like Mesh::cells: which of `values` a cell's node has
  std::vector<Tensor> values;
};

[[nodiscard]] NodalStress nodal_stress(const Mesh& mesh, const std::vector<Region>& regions,
                                       const std::vector<double>& displacement);

/// At a place: by the shape functions of its cell.
[[nodiscard]] Tensor stress_at(const Mesh& mesh, const NodalStress& stress, const Location& location);

}  // namespace nodal::elastic::finite_elements
