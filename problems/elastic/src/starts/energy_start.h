// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Starts that need equilibria: the best single factor of a rule, and the minimiser of the energy functional.

#include <array>
#include <vector>

#include <nodal/elastic/scene.h>

namespace nodal::elastic {

/// The factor c that minimises G(c·k): u = u_0 + u_1/c, u_0 from supports that move and u_1 from forces, so
/// 1/c = ⟨u_1, u_ref − u_0⟩_W / ⟨u_1, u_1⟩_W, without a search.
/// Refusal when the net can't carry its loads, when no load has a force, or when forces move the net
/// against its reference so that no positive factor helps.
[[nodiscard]] double best_scale(const Scene& scene, const std::vector<double>& stiffness);

/// The minimiser of the convex energy
///     J(k) = Σ_loads [½ fᵀK(k)⁻¹f − fᵀu_ref + ½ Σ_e k_e (b_e·u_ref)²],  ∂J/∂k_e = Σ_loads ½ (b_e·u_ref)² − ½ (b_e·u)²,
/// subject to bounds. J ≥ 0, and J = 0 exactly where u = u_ref: it is the energy norm of the misfit. One optimum, from
/// any start; found by a projected Newton method (Bertsekas 1982) whose steps come from preconditioned conjugate
/// gradients with Hessian products (b_e·u)(b_e·K⁻¹b_f)(b_f·u), one solve per load each. Valid where u_ref meets the
/// supports. Refusal when the net can't carry its loads, or a part of the reference isn't known.
[[nodiscard]] std::vector<double> energy_stiffness(const Scene& scene, const std::array<double, 2>& bounds);

}  // namespace nodal::elastic
