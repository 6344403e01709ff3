// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/objective.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace nodal::elastic {

Objective::Objective(std::vector<WeightedTerm> fitted, std::vector<std::shared_ptr<const Term>> held_out)
    : fitted_(std::move(fitted)), held_out_(std::move(held_out)) {
  if (fitted_.empty()) throw std::invalid_argument("an objective needs a term to fit");
  for (const WeightedTerm& part : fitted_)
    if (!(part.weight > 0.0)) throw std::invalid_argument("a fitted term's weight must be positive");
}

Abilities Objective::abilities() const {
  Abilities all = fitted_.front().term->abilities();
  for (const WeightedTerm& part : fitted_) {
    const Abilities own = part.term->abilities();
    all.gradient = all.gradient && own.gradient;
    all.residuals = all.residuals && own.residuals;
    all.jacobian_products = all.jacobian_products && own.jacobian_products;
    all.moves = all.moves && own.moves;
  }
  return all;
}

std::size_t Objective::residual_count() const {
  std::size_t count = 0;
  for (const WeightedTerm& part : fitted_) count += part.term->residual_count();
  return count;
}

std::vector<std::string> Objective::held_out_parts() const {
  std::vector<std::string> names;
  for (const auto& term : held_out_) std::ranges::move(term->parts(), std::back_inserter(names));
  return names;
}

std::unique_ptr<ObjectiveEvaluator> Objective::make_evaluator() const {
  return std::make_unique<ObjectiveEvaluator>(*this);
}

ObjectiveEvaluator::ObjectiveEvaluator(const Objective& objective) {
  std::size_t first = 0;
  for (const WeightedTerm& part : objective.fitted()) {
    const std::size_t count = part.term->residual_count();
    parts_.push_back(
        {part.term->make_evaluator(), part.weight, std::sqrt(part.weight), part.term->is_prior(), count, first});
    first += count;
  }
  for (const auto& term : objective.held_out()) held_out_.push_back({term.get(), nullptr, term->parts().size()});
}

// The first term that fails ends it: its status is the objective's.
template <class Ask>
Evaluation ObjectiveEvaluator::sum_of(Ask ask) {
  double cost = 0.0;
  for (Part& part : parts_) {
    const Evaluation evaluation = ask(*part.evaluator);
    if (!evaluation.ok()) return evaluation;
    cost += part.weight * evaluation.cost;
  }
  return {Status::ok, cost};
}

Evaluation ObjectiveEvaluator::value(const System& system) {
  return sum_of([&](TermEvaluator& term) { return term.value(system); });
}

// Figures of the solves behind different terms can't be mixed; errors of costs add up.
void ObjectiveEvaluator::add_health(const Part& part) {
  const Health own = part.evaluator->health();
  const std::optional<double> error = health_.cost_error;
  if (&part == &parts_.front() || (!health_.error_estimate && own.error_estimate)) health_ = own;
  if (own.cost_error) health_.cost_error = error.value_or(0.0) + part.weight * *own.cost_error;
}

Evaluation ObjectiveEvaluator::audit(const System& system) {
  health_ = {};
  Evaluation result{Status::ok, 0.0};
  double data = 0.0;
  for (const Part& part : parts_) {
    const Evaluation own = part.evaluator->audit(system);
    add_health(part);
    if (!own.ok()) return own;
    result.cost += part.weight * own.cost;
    if (!part.prior) data += part.weight * own.cost;
  }
  if (std::ranges::any_of(parts_, &Part::prior)) health_.data_cost = data;
  return result;
}

Status ObjectiveEvaluator::held_out_errors(const System& system, std::span<double> errors) {
  std::size_t first = 0;
  for (HeldOut& held : held_out_) {
    if (!held.evaluator) held.evaluator = held.term->make_evaluator();
    const Status status = held.evaluator->part_errors(system, errors.subspan(first, held.parts));
    if (status != Status::ok) return status;
    first += held.parts;
  }
  return Status::ok;
}

Status ObjectiveEvaluator::residuals(std::span<double> r) {
  for (Part& part : parts_) {
    const std::span<double> own = r.subspan(part.first, part.residuals);
    if (const Status status = part.evaluator->residuals(own); status != Status::ok) return status;
    if (part.weight != 1.0)
      for (double& entry : own) entry *= part.root;
  }
  return Status::ok;
}

Status ObjectiveEvaluator::add_gradient(const SystemGradient& gradient) {
  for (Part& part : parts_)
    if (const Status status = part.evaluator->add_gradient(part.weight, gradient); status != Status::ok) return status;
  return Status::ok;
}

Status ObjectiveEvaluator::product(const System& direction, std::span<double> jv) {
  for (Part& part : parts_) {
    const std::span<double> own = jv.subspan(part.first, part.residuals);
    if (const Status status = part.evaluator->product(direction, own); status != Status::ok) return status;
    if (part.weight != 1.0)
      for (double& entry : own) entry *= part.root;
  }
  return Status::ok;
}

Status ObjectiveEvaluator::add_transposed_product(std::span<const double> w, const SystemGradient& gradient) {
  for (Part& part : parts_) {
    std::span<const double> own = w.subspan(part.first, part.residuals);
    if (part.weight != 1.0) {
      scaled_.assign(own.begin(), own.end());
      for (double& entry : scaled_) entry *= part.root;
      own = scaled_;
    }
    if (const Status status = part.evaluator->add_transposed_product(own, gradient); status != Status::ok)
      return status;
  }
  return Status::ok;
}

Status ObjectiveEvaluator::jacobian(const Parameters& parameters, std::span<double> rows) {
  for (Part& part : parts_) {
    const std::span<double> own = rows.subspan(part.first * parameters.size(), part.residuals * parameters.size());
    if (const Status status = part.evaluator->jacobian(parameters, own); status != Status::ok) return status;
    if (part.weight != 1.0)
      for (double& entry : own) entry *= part.root;
  }
  return Status::ok;
}

Moves* ObjectiveEvaluator::moves() {
  if (parts_.size() == 1 && parts_.front().weight == 1.0) return parts_.front().evaluator->moves();
  if (moves_) return moves_.get();
  std::vector<ObjectiveMoves::Part> walks;
  for (const Part& part : parts_) {
    walks.push_back({part.evaluator->moves(), part.weight});
    if (!walks.back().walk) return nullptr;
  }
  moves_ = std::make_unique<ObjectiveMoves>(std::move(walks));
  return moves_.get();
}

Work ObjectiveEvaluator::work() const {
  Work total;
  for (const Part& part : parts_) total += part.evaluator->work();
  return total;
}

}  // namespace nodal::elastic
