// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The objective as optimizers see it: by coordinates x = ln k. It turns x into stiffnesses, asks the objective, and
/// chains derivatives back; what is computed, and by which factor, is the terms' affair.
///
/// Threads  one per thread.

#include <memory>
#include <vector>

#include "objective/objective.h"

namespace nodal::elastic {

class ElasticEvaluator final : public Evaluator {
 public:
  /// Both must outlive it.
  ElasticEvaluator(const Parameters& parameters, const Objective& objective);

  Evaluation value(std::span<const double> x) override;
  Evaluation audit(std::span<const double> x) override;
  [[nodiscard]] Status held_out_errors(std::span<const double> x, std::span<double> errors) override;
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient) override;
  Evaluation residuals(std::span<const double> x, std::span<double> residuals) override;
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals,
                                    std::span<double> jacobian) override;
  [[nodiscard]] Status gradient(std::span<double> gradient) override;
  [[nodiscard]] Status jacobian(std::span<double> jacobian) override;
  [[nodiscard]] Status jacobian_product(std::span<const double> v, std::span<double> jv) override;
  [[nodiscard]] Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) override;
  [[nodiscard]] Moves* moves() override { return objective_->moves(); }
  [[nodiscard]] Work work() const override { return objective_->work(); }
  [[nodiscard]] Health health() const override { return objective_->health(); }

 private:
  Evaluation evaluate(std::span<const double> x, bool refined);
  void require_point() const;

  const Parameters& parameters_;
  std::size_t residual_count_, held_out_count_;
  std::unique_ptr<ObjectiveEvaluator> objective_;
  std::vector<double> x_, stiffness_, by_spring_;
  bool at_point_ = false;  // x_ and what the terms keep belong to one successful evaluation
  bool refined_ = false;   // … and that was an audit
  double cost_ = 0.0;
};

}  // namespace nodal::elastic
