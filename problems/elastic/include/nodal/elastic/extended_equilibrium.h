// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The equilibrium in extended precision: what a result in doubles is measured against.
///
/// Solves K(k) u = f of a scene, K = Σ k_e b_e b_eᵀ, from the same doubles (directions, stiffnesses, forces, supports)
/// with 50 decimal digits throughout, by an LDLᵀ within the envelope of its own order of unknowns. It shares no code
/// with the solver that it checks but the scene's: assembly, order, factor and the sum of eq. (12) with its weights are
/// written again. Results are rounded to doubles at the very end.
///
/// Shapes   stiffness: [springs]; displacements: [loads][dimension · nodes].
/// Units    as the scene: N/m, N, m.
/// Cost     per support group one LDLᵀ at about 0.3 µs per operation: 0.1 s on a grid of 8 × 8 nodes, 4 groups.
/// Threads  a pure function.

#include <optional>
#include <span>
#include <vector>

#include <nodal/elastic/scene.h>
#include <nodal/elastic/state.h>

namespace nodal::elastic {

struct ExtendedState {
  double quality = 0.0;  ///< G (eq. 12)
  double cost = 0.0;     ///< ½ (G/‖u_ref‖_W)²
  std::vector<std::vector<double>> displacements;
};

/// Empty where K has a pivot ≤ 0, or where spring, force or stiffness is no finite number.
/// std::invalid_argument for a wrong number of stiffnesses.
[[nodiscard]] std::optional<ExtendedState> solve_extended(const Scene& scene, std::span<const double> stiffness);

/// How many multiplications its factors and solutions take, about.
[[nodiscard]] double extended_operations(const Scene& scene);

/// max over loads of ‖u − u_exact‖/‖u_exact‖: the error of displacements in doubles.
[[nodiscard]] double displacement_error(const State& state, const ExtendedState& exact);

}  // namespace nodal::elastic
