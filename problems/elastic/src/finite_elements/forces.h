// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a load is on a mesh: ∫ N t b over cells and ∫ N t (σ n) over sides.

#include <vector>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"

namespace nodal::elastic::finite_elements {

/// [nodes][dimension], N. std::invalid_argument for a label that no side has.
[[nodiscard]] std::vector<double> nodal_forces(const Mesh& mesh, const std::vector<Region>& regions, const Load& load);

}  // namespace nodal::elastic::finite_elements
