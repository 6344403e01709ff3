// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluators.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace nodal::analytic {

void PointEvaluator::require_size(std::size_t actual, std::size_t wanted, const char* what) {
  if (actual != wanted)
    throw std::invalid_argument(fmt::format("{} has {} entries; the problem needs {}", what, actual, wanted));
}

void PointEvaluator::require_point() const {
  if (!at_point_) throw std::logic_error("derivatives are asked for, but no point has been evaluated successfully");
}

Evaluation PointEvaluator::value(std::span<const double> x) {
  require_size(x.size(), x_.size(), "x");
  if (at_point_ && std::ranges::equal(x, x_)) return {Status::ok, cost_};
  std::ranges::copy(x, x_.begin());
  cost_ = compute_cost();
  at_point_ = std::isfinite(cost_);  // a coordinate that is none makes the cost no number either
  return at_point_ ? Evaluation{Status::ok, cost_} : Evaluation{Status::invalid_input, 0.0};
}

Evaluation PointEvaluator::value_and_gradient(std::span<const double> x, std::span<double> gradient_out) {
  require_size(gradient_out.size(), x_.size(), "gradient");
  const Evaluation result = value(x);
  if (result.ok()) compute_gradient(gradient_out);
  return result;
}

Status PointEvaluator::gradient(std::span<double> gradient) {
  require_point();
  require_size(gradient.size(), x_.size(), "gradient");
  compute_gradient(gradient);
  return Status::ok;
}

double LeastSquaresEvaluator::compute_cost() {
  have_entries_ = false;
  function_.residuals(point(), residuals_);
  double sum = 0.0;
  for (const double r : residuals_) sum += r * r;
  return 0.5 * sum;
}

const std::vector<Entry>& LeastSquaresEvaluator::entries() {
  if (!have_entries_) {
    entries_.clear();
    function_.jacobian(point(), entries_);
    have_entries_ = true;
  }
  return entries_;
}

void LeastSquaresEvaluator::multiply_transposed(std::span<const double> w, std::span<double> jtw) {
  std::ranges::fill(jtw, 0.0);
  for (const Entry& entry : entries()) jtw[entry.column] += entry.value * w[entry.row];
}

void LeastSquaresEvaluator::compute_gradient(std::span<double> gradient) { multiply_transposed(residuals_, gradient); }

Evaluation LeastSquaresEvaluator::residuals(std::span<const double> x, std::span<double> residuals_out) {
  require_size(residuals_out.size(), residuals_.size(), "residuals");
  const Evaluation result = value(x);
  if (result.ok()) std::ranges::copy(residuals_, residuals_out.begin());
  return result;
}

Evaluation LeastSquaresEvaluator::residuals_and_jacobian(std::span<const double> x, std::span<double> residuals_out,
                                                         std::span<double> jacobian_out) {
  require_size(jacobian_out.size(), residuals_.size() * point().size(), "jacobian");
  Evaluation result = residuals(x, residuals_out);
  if (result.ok()) result.status = jacobian(jacobian_out);
  return result;
}

Status LeastSquaresEvaluator::jacobian(std::span<double> jacobian) {
  require_point();
  require_size(jacobian.size(), residuals_.size() * point().size(), "jacobian");
  std::ranges::fill(jacobian, 0.0);
  for (const Entry& entry : entries()) jacobian[entry.row * point().size() + entry.column] = entry.value;
  return Status::ok;
}

Status LeastSquaresEvaluator::jacobian_product(std::span<const double> v, std::span<double> jv) {
  require_point();
  require_size(v.size(), point().size(), "v");
  require_size(jv.size(), residuals_.size(), "jv");
  std::ranges::fill(jv, 0.0);
  for (const Entry& entry : entries()) jv[entry.row] += entry.value * v[entry.column];
  return Status::ok;
}

Status LeastSquaresEvaluator::jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) {
  require_point();
  require_size(w.size(), residuals_.size(), "w");
  require_size(jtw.size(), point().size(), "jtw");
  multiply_transposed(w, jtw);
  return Status::ok;
}

}  // namespace nodal::analytic
