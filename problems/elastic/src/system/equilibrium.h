// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Static equilibrium of a spring system under one group of supports (paper, eq. 11).
///
/// Solves K(k) u = f, K = Σ k_e b_e b_eᵀ, on the freedoms that no support fixes. With prescribed values u_c the
/// right-hand side is f − K_fc u_c. Refinement sums the residual spring by spring, r = f − Σ k_e b_e (b_e·u), never
/// with the assembled K: only so does it recover the digits that assembling stiff and soft springs has lost. A full
/// refinement sums in long double: on slender bodies, what a node's forces lose to rounding bends the whole strip.
///
/// Order    vectors of a group are "placed": [0, free) are the free freedoms as the factor wants them, [free, freedoms)
///          the fixed ones, ascending, holding their prescribed values. `place` maps a freedom (Freedoms) there.
///
/// Units    stiffness N/m; displacements in a unit of the caller's, a power of two near the largest reference, so that
///          their squares stay in range at any size of body and no digit changes; forces in N per that unit.
/// Cost     one numeric factorization per `factorize`, one solve per load and refinement step; after the first call our
///          own code allocates nothing.
/// Threads  EquilibriumGroup: immutable, shared. Equilibrium: one thread.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/scene.h>

#include "geometry/with_dimension.h"
#include "system/factor/cholesky.h"

namespace nodal::elastic {

/// What is the same at all stiffnesses: the order of unknowns, where each spring goes, forces, references, weights.
class EquilibriumGroup {
 public:
  /// `displacement_unit` [m] must be a power of two.
  EquilibriumGroup(const Scene& scene, std::size_t group, double displacement_unit = 1.0);

  /// A load of this group, placed. `reference` and `forces` are [freedoms]; weights of fixed freedoms are 0.
  struct Load {
    std::size_t index = 0;  ///< in the scene's load set
    std::vector<double> forces, reference;
  };

  [[nodiscard]] std::size_t free() const noexcept { return free_; }
  [[nodiscard]] std::size_t freedoms() const noexcept { return place_.size(); }
  [[nodiscard]] std::span<const std::size_t> place() const noexcept { return place_; }
  [[nodiscard]] const std::vector<Load>& loads() const noexcept { return loads_; }
  [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
  [[nodiscard]] std::span<const double> prescribed() const noexcept { return prescribed_; }
  [[nodiscard]] const std::vector<Support>& supports() const noexcept { return supports_; }
  [[nodiscard]] const CholeskyPattern& pattern() const noexcept { return pattern_; }
  /// The freedom at a place; which node and axis that is, `numbering` says.
  [[nodiscard]] std::size_t freedom_at(std::size_t place) const noexcept { return freedom_[place]; }
  [[nodiscard]] const Freedoms& numbering() const noexcept { return numbering_; }
  [[nodiscard]] std::size_t node_at(std::size_t place) const noexcept { return numbering_.node_of(freedom_[place]); }
  [[nodiscard]] std::size_t springs() const noexcept { return springs_; }
  /// What can't be computed with whatever the stiffnesses are: a spring without length, a force that is no number.
  /// Empty when all is well.
  [[nodiscard]] const std::string& flaw() const noexcept { return flaw_; }

  /// b_e·u of placed displacements, computed in `Real`.
  template <class Real = double>
  [[nodiscard]] Real elongation(std::size_t spring, const double* u) const noexcept {
    return with_dimension(numbering_.dimension, [&](auto dimension) {
      const auto [d, low, high] = ends_of<dimension()>(spring);
      Real sum = d[0] * (Real{u[high[0]]} - u[low[0]]);
      for (std::size_t axis = 1; axis < dimension(); ++axis) sum += d[axis] * (Real{u[high[axis]]} - u[low[axis]]);
      return sum;
    });
  }
  /// |b_e|·|u|: what b_e·u could be without cancellation.
  [[nodiscard]] double elongation_magnitude(std::size_t spring, const double* u) const noexcept {
    return with_dimension(numbering_.dimension, [&](auto dimension) {
      const auto [d, low, high] = ends_of<dimension()>(spring);
      double sum = 0.0;
      for (std::size_t axis = 0; axis < dimension(); ++axis)
        sum += std::abs(d[axis]) * (std::abs(u[high[axis]]) + std::abs(u[low[axis]]));
      return sum;
    });
  }
  /// v += factor · |b_e|.
  void add_spring_magnitude(std::size_t spring, double factor, double* v) const noexcept {
    with_dimension(numbering_.dimension, [&](auto dimension) {
      const auto [d, low, high] = ends_of<dimension()>(spring);
      for (std::size_t axis = 0; axis < dimension(); ++axis) {
        v[low[axis]] += factor * std::abs(d[axis]);
        v[high[axis]] += factor * std::abs(d[axis]);
      }
    });
  }
  /// v += factor · b_e.
  template <class Real>
  void add_spring(std::size_t spring, Real factor, Real* v) const noexcept {
    with_dimension(numbering_.dimension, [&](auto dimension) {
      const auto [d, low, high] = ends_of<dimension()>(spring);
      for (std::size_t axis = 0; axis < dimension(); ++axis) {
        v[low[axis]] -= factor * d[axis];
        v[high[axis]] += factor * d[axis];
      }
    });
  }
  /// Sets a spring's places to zero: undoes add_spring on a vector of zeros.
  void clear_spring(std::size_t spring, double* v) const noexcept {
    const std::size_t count = 2 * numbering_.dimension;
    for (std::size_t k = 0; k < count; ++k) v[places_[spring * count + k]] = 0.0;
  }
  /// Rank of a place among the free freedoms, ascending: where its residual stands within its load.
  [[nodiscard]] std::size_t residual_at(std::size_t place) const noexcept { return residual_[place]; }
  /// Writes the free block of K(k) into a factor's values.
  void assemble(std::span<const double> stiffness, std::span<double> values) const noexcept;
  /// True when some support holds a freedom away from zero.
  [[nodiscard]] bool has_prescribed_motion() const noexcept { return moved_supports_; }

 private:
  // A spring's direction, and the places of its two ends' freedoms.
  struct Ends {
    const double* direction;
    const std::uint32_t *low, *high;
  };
  template <std::size_t D>
  [[nodiscard]] Ends ends_of(std::size_t spring) const noexcept {
    const std::uint32_t* low = places_.data() + 2 * D * spring;
    return {directions_.data() + D * spring, low, low + D};
  }
  struct Term {
    std::uint32_t spring;
    double factor;
  };

  void place_freedoms(const Scene& scene, std::size_t group);
  void gather_terms(const Scene& scene);
  void place_loads(const Scene& scene, std::size_t group);

  Freedoms numbering_;
  double displacement_unit_;
  std::string flaw_;
  std::vector<Support> supports_;
  std::vector<bool> fixed_;
  std::size_t free_ = 0;
  CholeskyPattern pattern_;
  std::vector<std::size_t> place_, freedom_, residual_;
  std::vector<double> prescribed_;  // [freedoms] placed, 0 on free freedoms
  bool moved_supports_ = false;
  std::vector<double> weights_;  // [freedoms] placed
  std::vector<Load> loads_;
  std::size_t springs_ = 0;
  std::vector<double> directions_;          // [springs][dimension]
  std::vector<std::uint32_t> places_;       // [springs][two ends][dimension]
  std::vector<std::uint32_t> term_begins_;  // values[i] = Σ over its terms of factor · k
  std::vector<Term> terms_;
};

/// How good a solve was; see Health.
struct Refinement {
  Status status = Status::ok;
  double error_estimate = 0.0;  ///< ‖δu₁‖/‖u‖ of the first correction
  double residual = 0.0;  ///< backward error ‖r‖/(‖f‖ + ‖|K||u|‖) before the last step: what rounding leaves is 1e-16
  double error_squared = 0.0;  ///< Σ_loads ‖u − u_exact‖²_W, estimated from the last correction and rounding
};

/// One correction leaves about the square of its own relative size: above this, one is not enough to trust.
inline constexpr double kSuspiciousCorrection = 1e-4;

/// True when a plain solve with a factor whose worst pivot kept `smallest_pivot_ratio` of its diagonal may be off by
/// more than a race allows (1e-10): cancellation in that pivot, growing with the number of unknowns, bounds what is
/// lost.
[[nodiscard]] bool plain_solve_loses(std::size_t unknowns, double smallest_pivot_ratio) noexcept;

class Equilibrium {
 public:
  explicit Equilibrium(const EquilibriumGroup& group);

  /// Assembles and factorizes; invalid_input when the group has a flaw. `stiffness` must stay as it is while this
  /// object is used.
  [[nodiscard]] Status factorize(std::span<const double> stiffness);
  /// After not_positive_definite: the node that gives way.
  [[nodiscard]] std::size_t failed_node() const { return group_.node_at(failed_position_); }
  /// The node whose freedom lost most digits in the last factorization that was ok.
  [[nodiscard]] std::size_t weakest_node() const { return group_.node_at(factor_.weakest_pivot().position); }
  /// Displacements of all loads by one solve, corrected once where the pivots say that digits were lost, and refined to
  /// the end where that correction is large: `ill_conditioned` when even that doesn't settle.
  [[nodiscard]] Status solve_loads();
  /// ‖δu‖/‖u‖ of the correction that the last solve_loads found necessary; 0 when none was.
  [[nodiscard]] double first_correction() const noexcept { return first_correction_; }
  /// Refines all loads until the corrections stop shrinking. ill_conditioned when they do so before rounding is
  /// reached, or when not even the first digit was right; not_positive_definite when a pivot was nothing but rounding.
  [[nodiscard]] Refinement refine();

  /// Placed displacements of a load of the group: [freedoms].
  [[nodiscard]] std::span<double> displacement(std::size_t load) noexcept {
    return std::span(displacements_).subspan(load * group_.freedoms(), group_.freedoms());
  }
  [[nodiscard]] std::span<const double> displacement(std::size_t load) const noexcept {
    return std::span(displacements_).subspan(load * group_.freedoms(), group_.freedoms());
  }
  [[nodiscard]] const EquilibriumGroup& group() const noexcept { return group_; }
  /// For derivatives: K⁻¹ of right-hand sides of free freedoms.
  [[nodiscard]] Cholesky& factor() noexcept { return factor_; }
  /// Solves in `count` columns, with the work counted.
  [[nodiscard]] std::span<const double> solve(std::size_t count);
  [[nodiscard]] const Work& work() const noexcept { return work_; }
  /// A vector of zeros, [freedoms], to work in until the next call.
  [[nodiscard]] std::span<double> scratch() noexcept {
    std::ranges::fill(scratch_, 0.0);
    return scratch_;
  }

 private:
  Status refusal(double first_correction);  // of a solve that refinement can't settle
  double error_squared(std::span<const double> correction);
  // One refinement step of all loads with the residual summed in `residual`; returns the largest ‖δu‖/‖u‖.
  template <class Real>
  double correct(std::vector<Real>& residual);

  const EquilibriumGroup& group_;
  Cholesky factor_;
  std::span<const double> stiffness_;
  std::vector<double> displacements_;                   // [loads][freedoms]
  std::vector<double> residual_, magnitude_, scratch_;  // [freedoms]
  std::vector<long double> long_residual_;              // [freedoms]
  std::span<const double> correction_;                  // of the last refinement step, until the next solve
  double last_residual_ = 0.0;
  double first_correction_ = 0.0;  // by solve_loads; 0 when it saw no need
  std::size_t failed_position_ = 0;
  Work work_;
};

}  // namespace nodal::elastic
