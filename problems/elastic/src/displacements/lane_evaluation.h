// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Values and derivatives of the elastic problem from the lane factor: all support groups in one pass, several times
/// faster than one CHOLMOD factorization per group. What races see may come from here; what is reported never does.
///
/// Accuracy the rule of Equilibrium::solve_loads with two digits more of caution, as pivots are inverted (RefactorForm
///          goes without these): where the worst pivot says that a solve may be off by more than 1e-10, one correction
///          with the residual summed spring by spring; where that is large, or the system is not positive definite,
///          nothing is said and CHOLMOD has to.
///
/// Cost     value: one lane factorization, one solve per slot; gradient and products: one solve per slot; Jacobian: a
///          path and a pass per spring. Nothing is allocated after the first call of each.
/// Threads  one per thread.

#include <optional>
#include <span>
#include <vector>

#include "displacements/lane_model.h"
#include "displacements/lane_work.h"
#include "displacements/point_derivatives.h"

namespace nodal::elastic {

/// Whether races get their values from here: by the study's `equilibrium.method`, and never where a number isn't
/// finite.
[[nodiscard]] bool values_by_lanes(const ElasticModel& model);

class LaneEvaluation final : public PointDerivatives {
 public:
  explicit LaneEvaluation(const ElasticModel& model);

  /// G² at [springs] stiffnesses, which must stay as they are; nothing where CHOLMOD has to be asked.
  [[nodiscard]] std::optional<double> solve(std::span<const double> stiffness);

  void residuals(std::span<double> residuals) override;
  void add_gradient(std::span<double> by_spring) override;
  void product(std::span<const double> factor, std::span<double> jv) override;
  void add_transposed_product(std::span<const double> w, std::span<double> by_spring) override;
  void add_jacobian(std::span<double> jacobian) override;
  [[nodiscard]] Work work() const override;

 private:
  // A residual: where it stands in a slot's vector, its place among the residuals, √w/‖u_ref‖_W.
  struct Residual {
    std::size_t at;
    std::size_t residual;
    double scale;
  };
  struct System {
    LaneSystem lanes;
    AlignedArray u;                                // [slots] vectors
    std::vector<std::vector<Residual>> residuals;  // by slot
    AlignedArray columns, factors;                 // of a Jacobian; made at the first one
  };

  const ElasticModel& model_;
  std::vector<System> systems_;
  std::span<const double> stiffness_;
  std::int64_t factorizations_ = 0, solves_ = 0, spring_solves_ = 0;
};

}  // namespace nodal::elastic
