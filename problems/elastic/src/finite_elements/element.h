// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One quadratic simplex: strains of its nodes' displacements, and its stiffness. The same in the plane and in space.
///
/// Voigt's order is xx yy xy in the plane, xx yy zz yz zx xy in space, shear strains γ = 2ε.

#include <array>
#include <cstddef>

#include <nodal/elastic/material.h>

#include "finite_elements/shape.h"

namespace nodal::elastic::finite_elements {

template <std::size_t D>
inline constexpr std::size_t kStrains = D*(D + 1) / 2;

/// Which two axes a strain is of.
template <std::size_t D>
[[nodiscard]] constexpr std::array<std::array<std::size_t, 2>, kStrains<D>> strain_axes() {
  if constexpr (D == std::size_t{2})
    return {{{0, 0}, {1, 1}, {0, 1}}};
  else
    return {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};
}

/// D of σ = D ε: the inverse of a compliance's rows and columns that a body of these dimensions has.
template <std::size_t D>
using Elastic = std::array<std::array<double, kStrains<D>>, kStrains<D>>;

/// Refusal for a compliance that isn't positive definite.
template <std::size_t D>
[[nodiscard]] Elastic<D> elastic_of(const Compliance& compliance);

/// ∇N of all nodes at barycentric coordinates.
template <std::size_t D>
using Gradients = std::array<std::array<double, D>, nodes_of_simplex(D)>;
template <std::size_t D>
[[nodiscard]] Gradients<D> shape_gradients(const std::array<Vector, 4>& of_vertices, const Barycentric& at);

/// ∫ Bᵀ D B over a cell, thickness 1: [node, axis][node, axis].
template <std::size_t D>
inline constexpr std::size_t kCellFreedoms = D* nodes_of_simplex(D);
template <std::size_t D>
using CellStiffness = std::array<std::array<double, kCellFreedoms<D>>, kCellFreedoms<D>>;
template <std::size_t D>
[[nodiscard]] CellStiffness<D> cell_stiffness(const Mesh& mesh, std::size_t cell, const Elastic<D>& elastic);

/// σ of nodal displacements [nodes][D] at a location.
template <std::size_t D>
[[nodiscard]] Tensor cell_stress(const Mesh& mesh, std::size_t cell, const Barycentric& at, const Elastic<D>& elastic,
                                 const std::vector<double>& displacement);

}  // namespace nodal::elastic::finite_elements
