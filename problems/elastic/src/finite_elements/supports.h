// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which freedoms of a mesh a group's supports hold.

#include <cstddef>
#include <vector>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"

namespace nodal::elastic::finite_elements {

struct HeldFreedoms {
  std::vector<char> held;             ///< [freedoms]
  std::vector<double> value;          ///< [freedoms], 0 where it is free
  std::vector<std::size_t> at_place;  ///< freedoms that are held at a place, and by no side
};

/// Errors as `solve`.
[[nodiscard]] HeldFreedoms held_freedoms(const Mesh& mesh, const std::vector<Prescribed>& prescribed);

}  // namespace nodal::elastic::finite_elements
