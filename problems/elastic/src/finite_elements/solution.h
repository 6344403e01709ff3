// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem solved on one mesh, by CHOLMOD.
///
/// Errors   Refusal: supports that leave the body free to move; a place that is held and no vertex; one freedom held at
///          two values; a compliance without inverse; memory beyond the limit (before it is taken).
///          std::invalid_argument: a region or label that isn't there.
/// Cost     one ordering per mesh, one factorization per group; some 0.1 s and 100 MB for 100,000 unknowns in the
/// plane.

#include <cstddef>
#include <limits>
#include <vector>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"

namespace nodal::elastic::finite_elements {

struct LoadSolution {
  std::vector<double> displacement;  ///< [nodes][dimension]
  /// The largest force that a support at a place bears beyond what is rounding, relative to the sum of all forces |f|.
  /// It should be 0: a single place of a continuum that bears a force is infinitely far away. Rounding is of stiffness
  /// times displacement, which with stiff and soft regions, or where supports move the body, is far above the forces.
  double borne_by_places = 0.0;
};

struct Solution {
  std::vector<LoadSolution> loads;  ///< those of the first group, then those of the second …
  std::size_t unknowns = 0;         ///< of the group with most
  double factor_bytes = 0.0;        ///< of the largest factor
};

[[nodiscard]] Solution solve(const Mesh& mesh, const Problem& problem,
                             double factor_bytes_limit = std::numeric_limits<double>::infinity());

}  // namespace nodal::elastic::finite_elements
