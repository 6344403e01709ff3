// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/elastic_evaluator.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "displacements/spread.h"
#include "moves/elastic_moves.h"

namespace nodal::elastic {

namespace {

void require_size(std::size_t actual, std::size_t wanted, const char* what) {
  if (actual != wanted)
    throw std::invalid_argument(fmt::format("{} has {} entries; the elastic problem needs {}", what, actual, wanted));
}

}  // namespace

ElasticEvaluator::ElasticEvaluator(const ElasticModel& model)
    : model_(model),
      by_lanes_(values_by_lanes(model)),
      x_(model.parameters.size()),
      stiffness_(model.parameters.springs()),
      by_spring_(model.parameters.springs()) {}

ElasticEvaluator::~ElasticEvaluator() = default;

// What is reported is CHOLMOD's, and so is what the lanes don't vouch for.
Evaluation ElasticEvaluator::evaluate_stiffness(bool refined) {
  at_point_ = false;
  double squared = 0.0;
  if (!refined && solve_by_lanes(squared)) {
    solver_ = lanes_.get();
  } else {
    const Status status = full().solve(stiffness_, refined);
    if (refined) health_ = full_->health();
    if (status != Status::ok) return {status, 0.0};
    squared = full_->squared();
    solver_ = full_.get();
  }
  at_point_ = true;
  refined_ = refined;
  cost_ = model_.cost(squared);
  return {Status::ok, cost_};
}

FullEvaluation& ElasticEvaluator::full() {
  if (!full_) full_ = std::make_unique<FullEvaluation>(model_);
  return *full_;
}

bool ElasticEvaluator::solve_by_lanes(double& squared) {
  if (!by_lanes_ || !std::ranges::all_of(stiffness_, usable_stiffness)) return false;
  if (!lanes_) lanes_ = std::make_unique<LaneEvaluation>(model_);
  const std::optional<double> solved = lanes_->solve(stiffness_);
  squared = solved.value_or(0.0);
  return solved.has_value();
}

Evaluation ElasticEvaluator::evaluate(std::span<const double> x, bool refined) {
  require_size(x.size(), x_.size(), "x");
  // A refined point is evaluated again: what a race sees must not depend on what was looked at before.
  if (!refined && at_point_ && !refined_ && std::ranges::equal(x, x_)) return {Status::ok, cost_};
  std::ranges::copy(x, x_.begin());
  model_.parameters.stiffness(x, stiffness_);
  return evaluate_stiffness(refined);
}

Evaluation ElasticEvaluator::value(std::span<const double> x) { return evaluate(x, false); }

Evaluation ElasticEvaluator::audit(std::span<const double> x) {
  health_ = {};
  const Evaluation result = evaluate(x, true);
  if (result.ok()) health_.findings = {spread_of(stiffness_)};
  return result;
}

Evaluation ElasticEvaluator::solve_refined(std::span<const double> stiffness, std::string& message) {
  require_size(stiffness.size(), stiffness_.size(), "stiffness");
  std::ranges::copy(stiffness, stiffness_.begin());
  const Evaluation result = evaluate_stiffness(true);
  at_point_ = false;  // there need not be an x for these stiffnesses
  if (!result.ok()) message = full().describe(result.status);
  return result;
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
  require_size(residuals.size(), model_.residual_count, "residuals");
  const Evaluation result = evaluate(x, false);
  if (result.ok()) solver_->residuals(residuals);
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
  solver_->add_gradient(by_spring_);
  for (double& entry : by_spring_) entry *= model_.inverse_reference_squared;
  model_.parameters.chain(stiffness_, by_spring_, gradient);
  return Status::ok;
}

Status ElasticEvaluator::jacobian(std::span<double> jacobian) {
  require_point();
  require_size(jacobian.size(), model_.residual_count * x_.size(), "jacobian");
  std::ranges::fill(jacobian, 0.0);
  solver_->add_jacobian(jacobian);
  return Status::ok;
}

Status ElasticEvaluator::jacobian_product(std::span<const double> v, std::span<double> jv) {
  require_point();
  require_size(v.size(), x_.size(), "v");
  require_size(jv.size(), model_.residual_count, "jv");
  for (std::size_t e = 0; e < by_spring_.size(); ++e)
    by_spring_[e] = stiffness_[e] * v[model_.parameters.coordinate_of(e)];
  solver_->product(by_spring_, jv);
  return Status::ok;
}

Status ElasticEvaluator::jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) {
  require_point();
  require_size(w.size(), model_.residual_count, "w");
  require_size(jtw.size(), x_.size(), "jtw");
  std::ranges::fill(by_spring_, 0.0);
  solver_->add_transposed_product(w, by_spring_);
  model_.parameters.chain(stiffness_, by_spring_, jtw);
  return Status::ok;
}

Moves* ElasticEvaluator::moves() {
  if (!moves_) moves_ = std::make_unique<ElasticMoves>(model_);
  return moves_.get();
}

Work ElasticEvaluator::work() const {
  Work total;
  if (full_) total += full_->work();
  if (lanes_) total += lanes_->work();
  if (moves_) total += moves_->work();
  return total;
}

}  // namespace nodal::elastic
