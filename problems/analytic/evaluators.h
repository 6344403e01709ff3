// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Evaluators of the test functions. None allocates once each of its calls was made.

#include <vector>

#include <nodal/evaluator.h>

#include "function.h"

namespace nodal::analytic {

/// What both kinds share: the last point, and the gradient there.
class PointEvaluator : public Evaluator {
 public:
  explicit PointEvaluator(std::size_t dimension) : x_(dimension) {}

  Evaluation value(std::span<const double> x) final;
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient_out) final;
  [[nodiscard]] Status gradient(std::span<double> gradient) final;

 protected:
  /// The cost at `point()`, which has just changed.
  virtual double compute_cost() = 0;
  virtual void compute_gradient(std::span<double> gradient) = 0;

  [[nodiscard]] std::span<const double> point() const noexcept { return x_; }
  /// std::logic_error when the last evaluation failed, or there was none.
  void require_point() const;
  /// std::invalid_argument.
  static void require_size(std::size_t actual, std::size_t wanted, const char* what);

 private:
  std::vector<double> x_;
  double cost_ = 0.0;
  bool at_point_ = false;
};

class SmoothEvaluator final : public PointEvaluator {
 public:
  SmoothEvaluator(const Smooth& function, std::size_t dimension) : PointEvaluator(dimension), function_(function) {}

 private:
  double compute_cost() override { return function_.value(point()); }
  void compute_gradient(std::span<double> gradient) override { function_.gradient(point(), gradient); }

  const Smooth& function_;
};

class LeastSquaresEvaluator final : public PointEvaluator {
 public:
  LeastSquaresEvaluator(const LeastSquares& function, std::size_t dimension)
      : PointEvaluator(dimension), function_(function), residuals_(function.residual_count(dimension)) {}

  Evaluation residuals(std::span<const double> x, std::span<double> residuals_out) override;
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals_out,
                                    std::span<double> jacobian_out) override;
  [[nodiscard]] Status jacobian(std::span<double> jacobian) override;
  [[nodiscard]] Status jacobian_product(std::span<const double> v, std::span<double> jv) override;
  [[nodiscard]] Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) override;

 private:
  double compute_cost() override;
  void compute_gradient(std::span<double> gradient) override;
  const std::vector<Entry>& entries();  // of the Jacobian at the point, computed once for each
  void multiply_transposed(std::span<const double> w, std::span<double> jtw);

  const LeastSquares& function_;
  std::vector<double> residuals_;
  std::vector<Entry> entries_;
  bool have_entries_ = false;
};

}  // namespace nodal::analytic
