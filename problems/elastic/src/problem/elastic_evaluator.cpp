// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/elastic_evaluator.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

void require_size(std::size_t actual, std::size_t wanted, const char* what) {
  if (actual != wanted)
    throw std::invalid_argument(fmt::format("{} has {} entries; the elastic problem needs {}", what, actual, wanted));
}

}  // namespace

ElasticEvaluator::ElasticEvaluator(const Parameters& parameters, const Objective& objective)
    : parameters_(parameters),
      residual_count_(objective.residual_count()),
      held_out_count_(objective.held_out_parts().size()),
      objective_(objective.make_evaluator()),
      x_(parameters.size()),
      stiffness_(parameters.springs()),
      by_spring_(parameters.springs()) {}

Evaluation ElasticEvaluator::evaluate(std::span<const double> x, bool refined) {
  require_size(x.size(), x_.size(), "x");
  // A refined point is evaluated again: what a race sees must not depend on what was looked at before.
  if (!refined && at_point_ && !refined_ && std::ranges::equal(x, x_)) return {Status::ok, cost_};
  std::ranges::copy(x, x_.begin());
  parameters_.stiffness(x, stiffness_);
  const Evaluation result = refined ? objective_->audit({stiffness_}) : objective_->value({stiffness_});
  at_point_ = result.ok();
  refined_ = refined;
  cost_ = result.cost;
  return result;
}

Evaluation ElasticEvaluator::value(std::span<const double> x) { return evaluate(x, false); }

Evaluation ElasticEvaluator::audit(std::span<const double> x) { return evaluate(x, true); }

// By stiffnesses of its own: those of the last point stay where they are.
Status ElasticEvaluator::held_out_errors(std::span<const double> x, std::span<double> errors) {
  require_size(x.size(), x_.size(), "x");
  require_size(errors.size(), held_out_count_, "errors");
  std::vector<double> stiffness(stiffness_.size());
  parameters_.stiffness(x, stiffness);
  return objective_->held_out_errors({stiffness}, errors);
}

void ElasticEvaluator::require_point() const {
  if (!at_point_) throw std::logic_error("derivatives are asked for, but no point has been evaluated successfully");
}

Evaluation ElasticEvaluator::value_and_gradient(std::span<const double> x, std::span<double> gradient_out) {
  Evaluation result = evaluate(x, false);
  if (result.ok()) result.status = gradient(gradient_out);
  return result;
}

Evaluation ElasticEvaluator::residuals(std::span<const double> x, std::span<double> residuals) {
  require_size(residuals.size(), residual_count_, "residuals");
  Evaluation result = evaluate(x, false);
  if (result.ok()) result.status = objective_->residuals(residuals);
  return result;
}

Evaluation ElasticEvaluator::residuals_and_jacobian(std::span<const double> x, std::span<double> residuals_out,
                                                    std::span<double> jacobian_out) {
  Evaluation result = residuals(x, residuals_out);
  if (result.ok()) result.status = jacobian(jacobian_out);
  return result;
}

Status ElasticEvaluator::gradient(std::span<double> gradient) {
  require_point();
  require_size(gradient.size(), x_.size(), "gradient");
  std::ranges::fill(by_spring_, 0.0);
  const Status status = objective_->add_gradient({by_spring_});
  if (status == Status::ok) parameters_.chain(stiffness_, by_spring_, gradient);
  return status;
}

Status ElasticEvaluator::jacobian(std::span<double> jacobian) {
  require_point();
  require_size(jacobian.size(), residual_count_ * x_.size(), "jacobian");
  return objective_->jacobian(parameters_, jacobian);
}

Status ElasticEvaluator::jacobian_product(std::span<const double> v, std::span<double> jv) {
  require_point();
  require_size(v.size(), x_.size(), "v");
  require_size(jv.size(), residual_count_, "jv");
  for (std::size_t e = 0; e < by_spring_.size(); ++e) by_spring_[e] = stiffness_[e] * v[parameters_.coordinate_of(e)];
  return objective_->product({by_spring_}, jv);
}

Status ElasticEvaluator::jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) {
  require_point();
  require_size(w.size(), residual_count_, "w");
  require_size(jtw.size(), x_.size(), "jtw");
  std::ranges::fill(by_spring_, 0.0);
  const Status status = objective_->add_transposed_product(w, {by_spring_});
  if (status == Status::ok) parameters_.chain(stiffness_, by_spring_, jtw);
  return status;
}

}  // namespace nodal::elastic
