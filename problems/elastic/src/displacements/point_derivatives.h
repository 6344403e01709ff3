// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What can be asked at a point that has been solved for, whichever factor solved it. By springs and in k: the chain to
/// coordinates, and ln k, is ElasticEvaluator's.
///
/// With u = K⁻¹f and r = √W (u − u_ref)/‖u_ref‖_W on the free freedoms, as ElasticProblem orders them.
///
/// Threads  as the object that implements it: one thread.

#include <span>

#include <nodal/evaluator.h>

namespace nodal::elastic {

class PointDerivatives {
 public:
  virtual ~PointDerivatives() = default;

  virtual void residuals(std::span<double> residuals) = 0;
  /// by_spring[e] −= Σ_loads (b_e·p)(b_e·u) with K p = W(u − u_ref): ∂(½G²)/∂k_e is added.
  virtual void add_gradient(std::span<double> by_spring) = 0;
  /// jv = Σ_e ∂r/∂k_e factor_e; one solve per load.
  virtual void product(std::span<const double> factor, std::span<double> jv) = 0;
  /// by_spring[e] += w·∂r/∂k_e; one solve per load.
  virtual void add_transposed_product(std::span<const double> w, std::span<double> by_spring) = 0;
  /// Adds k_e ∂r/∂k_e into column coordinate_of(e) of a [residuals][coordinates] matrix; one solve per spring and
  /// group.
  virtual void add_jacobian(std::span<double> jacobian) = 0;

  [[nodiscard]] virtual Work work() const = 0;

 protected:
  PointDerivatives() = default;
  PointDerivatives(const PointDerivatives&) = delete;
  PointDerivatives& operator=(const PointDerivatives&) = delete;
};

}  // namespace nodal::elastic
