// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Evaluates the elastic problem: values, and derivatives from the same factorizations.
///
/// With u = K⁻¹f and r = √W (u − u_ref)/‖u_ref‖_W:
///   gradient  K p = W(u − u_ref), ∂(½G²)/∂k_e = −(b_e·p)(b_e·u)          one more solve per load
///   Jacobian  ∂u/∂k_e = −K⁻¹b_e (b_e·u)                                  one solve per spring and group
///   J v       −K⁻¹ Σ_e b_e (b_e·u) v_e;  Jᵀw like the gradient           one solve per load
/// and in x = ln k each ∂/∂k_e times k_e, summed over tied springs.
///
/// Values that races see come from the lane factor where it can be trusted (lanes/lane_evaluation.h), from CHOLMOD
/// otherwise; audits always come from CHOLMOD, refined. Derivatives come from whichever solved for the point.
///
/// Cost     value: one factorization of all groups, one solve per load. After the first call of each kind our own code
///          allocates nothing.
/// Threads  one per thread.

#include <memory>
#include <vector>

#include "displacements/full_evaluation.h"
#include "displacements/lane_evaluation.h"

namespace nodal::elastic {

class ElasticMoves;

class ElasticEvaluator final : public Evaluator {
 public:
  explicit ElasticEvaluator(const ElasticModel& model);
  ~ElasticEvaluator() override;

  Evaluation value(std::span<const double> x) override;
  Evaluation audit(std::span<const double> x) override;
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient) override;
  Evaluation residuals(std::span<const double> x, std::span<double> residuals) override;
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals,
                                    std::span<double> jacobian) override;
  [[nodiscard]] Status gradient(std::span<double> gradient) override;
  [[nodiscard]] Status jacobian(std::span<double> jacobian) override;
  [[nodiscard]] Status jacobian_product(std::span<const double> v, std::span<double> jv) override;
  [[nodiscard]] Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) override;
  [[nodiscard]] Moves* moves() override;
  [[nodiscard]] Work work() const override;
  [[nodiscard]] Health health() const override { return health_; }

  /// The same by stiffnesses, which bounds and parameters don't restrict: refined. `message` says what is wrong.
  Evaluation solve_refined(std::span<const double> stiffness, std::string& message);
  [[nodiscard]] Equilibrium& equilibrium(std::size_t group) { return full().group(group); }

 private:
  Evaluation evaluate(std::span<const double> x, bool refined);
  Evaluation evaluate_stiffness(bool refined);
  void require_point() const;
  bool solve_by_lanes(double& squared);
  FullEvaluation& full();

  const ElasticModel& model_;
  bool by_lanes_;
  std::unique_ptr<LaneEvaluation> lanes_;  // both made when first needed: a race may never need CHOLMOD's factors
  std::unique_ptr<FullEvaluation> full_;
  PointDerivatives* solver_ = nullptr;  // the one of the two that solved for the point
  std::vector<double> x_, stiffness_, by_spring_;
  bool at_point_ = false;  // x_, factors and displacements belong to one successful evaluation
  bool refined_ = false;   // … and that was an audit
  double cost_ = 0.0;
  Health health_;
  std::unique_ptr<ElasticMoves> moves_;
};

}  // namespace nodal::elastic
