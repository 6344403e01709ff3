// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The hot loops of values, derivatives and annealing, for several support groups at once in the lanes of one vector.
///
/// K is factored on the node graph in D×D blocks, K = L D Lᵀ, with D_j⁻¹ kept instead of D_j. A spring e changed by δ
/// changes the factor along one path of the elimination tree. With w_j what is left of b when column j is reached,
/// H_j = Σ_{i ≤ j} w_iᵀD_i⁻¹w_i and m_j = δ/(1 + δH_j) · D_j⁻¹w_j, one pass along the path does
///     D_j⁻¹ −= m_j (D_j⁻¹w_j)ᵀ,    w_i −= L_ij w_j,    L_ij += w_i m_jᵀ,
/// and leaves in m the forward solution of the *changed* system, times δ: a backward pass gives ẑ = δ K'⁻¹b. So update
/// and forward solve are one pass, and their divisions don't wait for each other.
///
/// The price list of a spring f is Q = b_f·K⁻¹b_f and R = z_f·Wz_f per group, t = z_f·W(u − u_ref) and v = b_f·u per
/// load. With σ = 1 + δQ_e, α = δv_e/σ:
///     price      G'² = G² + Σ α(αR_e − 2t_e)
///     accept     q̂ = b_f·ẑ, ρ̂ = b_f·K'⁻¹Wẑ, κ = σ/δ, with Q_e, R_e, t_e, v_e as they were:
///                Q −= κq̂²,  R −= q̂(R_e q̂ + 2κρ̂),  t −= v_e ρ̂ + t_e q̂,  v −= v_e q̂.
/// For the changed spring itself Q = q̂/δ and R = ρ̂/δ (f = e), and R_e above is σ² times that.
/// (The derivation: docs/formulation/moves.md. In terms of the changed system's solutions nothing is divided by
/// σ, and one factor serves.)
///
/// Held freedoms have unit rows, so they stay 0 in every solution of K: in z, in adjoints, in steps. Where they are
/// held at u_c ≠ 0 they are in u itself: K_ff u_f = f_f − Σ_e k_e (b_e)_f (b_e·u_c), spring by spring. What follows is
/// written in b_e·u of the whole u and stays as it is. A changed spring adds δ (b_e)_f b_e·u to the left side, with u_c
/// in b_e·u, so u'_f = u_f − z_f α with the α above; for the same reason ∂u_f/∂k_e = −K⁻¹(b_e)_f (b_e·u). The price
/// list doesn't know the difference: only its v has u_c in it, and stays exact since u_c doesn't change.
///
/// Cost     price: O(1). change: the blocks of the columns on one path, read and written. Solves: every block once or
///          twice. update_table: O(springs).
/// Threads  one view per thread.

#include <cstdint>

#include "lane_view.h"

namespace nodal::elastic {

/// What a priced change would do to G². `trusted` is false when K would hardly be positive definite any more, or not at
/// all: σ ≤ 1e-5 for some group.
struct LanePrice {
  double change = 0.0;
  bool trusted = false;
};

/// What became of a factorization. `failed` is the elimination position whose pivot is not positive definite.
struct LaneFactored {
  bool fine = false;
  std::uint32_t failed = 0;
  double smallest_pivot_ratio = 0.0;  ///< min_j D_jj/K_jj over all groups: how much of the worst pivot was left
};

struct LaneKernels {
  /// Assembles K(stiffness) and factors it.
  LaneFactored (*factorize)(const LaneView&, const double* stiffness);
  /// x: [nodes] vectors, in place: K⁻¹x.
  void (*solve)(const LaneView&, double* x);
  /// z = K⁻¹b_e by a path forward and a full backward pass.
  void (*solve_spring)(const LaneView&, std::uint32_t spring, double* z);
  /// u = K⁻¹(force − what moved supports bring) + prescribed of every slot, into [slots][nodes] vectors.
  void (*solve_loads)(const LaneView&, const double* stiffness, double* u);
  /// One refinement step of a slot's u: the residual force − Σ k_e b_e (b_e·u), spring by spring, solved for and added.
  /// The largest ‖δu‖/‖u‖ over the groups, of free freedoms; infinity where that is no number. Works in view.y.
  double (*correct)(const LaneView&, const double* stiffness, std::uint32_t slot, double* u);
  /// y = weight (u − reference) of a slot.
  void (*weighted_error)(const LaneView&, std::uint32_t slot, const double* u, double* y);
  /// p = K⁻¹y in place, then by_spring[e] −= Σ_groups (b_e·p)(b_e·u).
  void (*adjoint)(const LaneView&, const double* u, double* y, double* by_spring);
  /// y = −K⁻¹ Σ_e b_e (b_e·u) factor_e.
  void (*product)(const LaneView&, const double* u, const double* factor, double* y);
  /// Σ weight (u − reference)² over slots, nodes and groups.
  double (*squared_error)(const LaneView&, const double* u);

  /// u −= z δ(b_e·u)/(1 + δ b_e·z) in every slot, given z = K⁻¹b_e. False when 1 + δ b_e·z ≤ 0 for some group.
  bool (*displace)(const LaneView&, std::uint32_t spring, double change, const double* z, double* u);
  /// other −= z δ(b_e·other)/(1 + δ b_e·z): K⁻¹ of another vector after the spring has changed.
  void (*displace_one)(const LaneView&, std::uint32_t spring, double change, const double* z, double* other);
  /// The factor of K + δ b_e b_eᵀ; view.z = ẑ's forward solution. False when it is not positive definite: refactorize.
  bool (*change_factor)(const LaneView&, std::uint32_t spring, double change);

  LanePrice (*price)(const LaneView&, const double* table_row, double change);
  /// Fills one row of the price list from z = K⁻¹b_e and u.
  void (*fill_row)(const LaneView&, std::uint32_t spring, const double* z, const double* u, double* table_row);
  /// change_factor, ẑ and K'⁻¹Wẑ into view.z and view.y.
  bool (*change_and_solve)(const LaneView&, std::uint32_t spring, double change);
  /// Brings the whole price list up to date, given ẑ in view.z and K'⁻¹Wẑ in view.y.
  void (*update_table)(const LaneView&, std::uint32_t spring, double change, double* table);
};

}  // namespace nodal::elastic
