// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What every evaluator and walk of one elastic problem shares: the scene, its parameters, and per support group the
/// structure of its equilibrium.
///
/// Threads  immutable.

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "system/equilibrium.h"

namespace nodal::elastic {

struct LaneModel;

struct ElasticModel {
  explicit ElasticModel(Scene scene_of_problem);
  ~ElasticModel();

  /// What walks and lane evaluations share; made at the first call. Safe to call from several threads.
  [[nodiscard]] const LaneModel& lanes() const;

  /// ½ (G/‖u_ref‖_W)² from G² = Σ w (u − u_ref)².
  [[nodiscard]] double cost(double squared_quality) const noexcept {
    return 0.5 * squared_quality * inverse_reference_squared;
  }
  /// What a cost may be off by when displacements are off by Σ ‖·‖²_W = `error_squared`: with r = √(2 cost) and
  /// Δ = √error_squared/‖u_ref‖_W that is rΔ + ½Δ², and the rounding of the sums themselves.
  [[nodiscard]] double cost_error(double cost, double error_squared) const noexcept;

  Scene scene;
  Parameters parameters;
  std::vector<std::unique_ptr<EquilibriumGroup>> groups;
  double displacement_unit = 1.0;  ///< [m], a power of two: groups, and all that is computed in them, measure by it
  double reference_norm = 0.0;     ///< ‖u_ref‖_W over all loads [displacement_unit]
  double inverse_reference_squared = 0.0;
  double reference_error = 0.0;         ///< ‖uncertainty‖_W/‖u_ref‖_W: a relative error below it is no result
  std::vector<double> reference_norms;  ///< by load: ‖u_ref,l‖_W [displacement_unit]
  std::size_t residual_count = 0;       ///< free freedoms, summed over loads
  std::vector<std::size_t> first_residual;  ///< by load

 private:
  mutable std::once_flag lanes_made_;
  mutable std::unique_ptr<const LaneModel> lanes_;
};

/// A stiffness that arithmetic can be trusted with: finite, and not so small that it has lost digits.
[[nodiscard]] inline bool usable_stiffness(double k) {
  return std::isfinite(k) && (k == 0.0 || std::abs(k) >= std::numeric_limits<double>::min());
}

/// Σ w (u − u_ref)² of one load, placed.
[[nodiscard]] inline double squared_error(const EquilibriumGroup& group, std::size_t load, const double* u) noexcept {
  const double* reference = group.loads()[load].reference.data();
  const double* weight = group.weights().data();
  double sum = 0.0;
  for (std::size_t i = 0; i < group.free(); ++i) {
    const double difference = u[i] - reference[i];
    sum += weight[i] * difference * difference;
  }
  return sum;
}

}  // namespace nodal::elastic
