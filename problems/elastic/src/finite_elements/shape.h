// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Quadratic shape functions on simplices and exact quadrature over them, of 1, 2 and 3 dimensions.
///
/// N_i = λ_i (2 λ_i − 1) at vertices, N_ij = 4 λ_i λ_j at middles, λ barycentric.
/// Source   quadrature: D. A. Dunavant, IJNME 21 (1985), and Gauss.

#include <array>
#include <cstddef>
#include <vector>

#include "finite_elements/mesh.h"

namespace nodal::elastic::finite_elements {

[[nodiscard]] inline std::array<double, 10> shape_functions(std::size_t dimension, const Barycentric& l) {
  std::array<double, 10> n{};
  for (std::size_t i = 0; i <= dimension; ++i) n[i] = l[i] * (2.0 * l[i] - 1.0);
  const std::size_t edges = dimension * (dimension + 1) / 2;
  for (std::size_t e = 0; e < edges; ++e) n[dimension + 1 + e] = 4.0 * l[kEdges[e][0]] * l[kEdges[e][1]];
  return n;
}

struct QuadraturePoint {
  Barycentric at{};
  double weight = 0.0;  ///< they sum to 1
};

/// Exact for polynomials of degree 2: products of two strains, and a shape function times a constant.
[[nodiscard]] const std::vector<QuadraturePoint>& cell_quadrature(std::size_t dimension);

/// Over a side of so many dimensions (1 or 2), exact for degree 5 on a line and 4 on a triangle: a shape function times
/// a traction that is linear, and more.
[[nodiscard]] const std::vector<QuadraturePoint>& side_quadrature(std::size_t dimension);

}  // namespace nodal::elastic::finite_elements
