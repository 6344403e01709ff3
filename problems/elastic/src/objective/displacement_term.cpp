// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/displacement_term.h"

#include <algorithm>
#include <stdexcept>

#include "displacements/findings.h"

namespace nodal::elastic {

std::vector<std::string> DisplacementTerm::parts() const {
  std::vector<std::string> loads;
  for (const LoadCase& load : model_.scene.loads.loads) loads.push_back(load.name);
  return loads;
}

std::unique_ptr<TermEvaluator> DisplacementTerm::make_evaluator() const {
  return std::make_unique<DisplacementEvaluator>(model_);
}

DisplacementEvaluator::DisplacementEvaluator(const ElasticModel& model)
    : model_(model), by_lanes_(values_by_lanes(model)), by_spring_(model.parameters.springs()) {}

FullEvaluation& DisplacementEvaluator::full() {
  if (!full_) full_ = std::make_unique<FullEvaluation>(model_);
  return *full_;
}

// What the lanes don't vouch for is CHOLMOD's.
Evaluation DisplacementEvaluator::value(const System& system) {
  if (by_lanes_ && std::ranges::all_of(system.stiffness, usable_stiffness)) {
    if (!lanes_) lanes_ = std::make_unique<LaneEvaluation>(model_);
    if (const std::optional<double> squared = lanes_->solve(system.stiffness)) {
      solver_ = lanes_.get();
      return {Status::ok, model_.cost(*squared)};
    }
  }
  const Status status = full().solve(system.stiffness);
  if (status != Status::ok) return {status, 0.0};
  solver_ = full_.get();
  return {Status::ok, model_.cost(full_->squared())};
}

Evaluation DisplacementEvaluator::audit(const System& system) {
  const Status status = full().solve(system.stiffness, true);
  health_ = full_->health();
  if (status != Status::ok) return {status, 0.0};
  solver_ = full_.get();
  health_.findings = findings_of(model_, system.stiffness);
  return {Status::ok, model_.cost(full_->squared())};
}

Status DisplacementEvaluator::residuals(std::span<double> r) {
  solver_->residuals(r);
  return Status::ok;
}

Status DisplacementEvaluator::add_gradient(double weight, const SystemGradient& gradient) {
  std::ranges::fill(by_spring_, 0.0);
  solver_->add_gradient(by_spring_);
  for (std::size_t e = 0; e < by_spring_.size(); ++e)
    gradient.stiffness[e] += weight * (by_spring_[e] * model_.inverse_reference_squared);
  return Status::ok;
}

Status DisplacementEvaluator::product(const System& direction, std::span<double> jv) {
  solver_->product(direction.stiffness, jv);
  return Status::ok;
}

Status DisplacementEvaluator::add_transposed_product(std::span<const double> w, const SystemGradient& gradient) {
  solver_->add_transposed_product(w, gradient.stiffness);
  return Status::ok;
}

Status DisplacementEvaluator::jacobian(const Parameters& parameters, std::span<double> rows) {
  if (&parameters != &model_.parameters) throw std::invalid_argument("jacobian: parameters of another model");
  std::ranges::fill(rows, 0.0);
  solver_->add_jacobian(rows);
  return Status::ok;
}

Status DisplacementEvaluator::part_errors(const System& system, std::span<double> errors) {
  const Status status = full().solve(system.stiffness);
  if (status != Status::ok) return status;
  solver_ = full_.get();
  full_->load_errors(errors);
  return status;
}

Moves* DisplacementEvaluator::moves() {
  if (!moves_) moves_ = std::make_unique<ElasticMoves>(model_);
  return moves_.get();
}

Work DisplacementEvaluator::work() const {
  Work total;
  if (full_) total += full_->work();
  if (lanes_) total += lanes_->work();
  if (moves_) total += moves_->work();
  return total;
}

}  // namespace nodal::elastic
