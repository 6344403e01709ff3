// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/prior_term.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace nodal::elastic {

PriorTerm::PriorTerm(const Parameters& parameters, std::vector<double> about)
    : parameters_(parameters), about_(std::move(about)) {
  if (about_.size() != parameters_.springs())
    throw std::invalid_argument("a prior needs a stiffness for each of the springs");
  if (!std::ranges::all_of(about_, [](double k) { return std::isnormal(k) && k > 0.0; }))
    throw std::invalid_argument("a prior's stiffnesses must be positive numbers");
}

std::unique_ptr<TermEvaluator> PriorTerm::make_evaluator() const {
  return std::make_unique<PriorEvaluator>(parameters_, about_);
}

PriorEvaluator::PriorEvaluator(const Parameters& parameters, std::span<const double> about)
    : parameters_(parameters),
      about_(about),
      root_(1.0 / std::sqrt(static_cast<double>(about.size()))),
      logarithm_(about.size()) {}

// Of the quotient, not as a difference of logarithms: next to k_0 that would lose its digits.
template <class Real>
Evaluation PriorEvaluator::evaluate(const System& system) {
  stiffness_ = system.stiffness;
  Real sum = 0;
  for (std::size_t e = 0; e < about_.size(); ++e) {
    const Real logarithm = std::log(static_cast<Real>(stiffness_[e]) / static_cast<Real>(about_[e]));
    sum += logarithm * logarithm;
    logarithm_[e] = static_cast<double>(logarithm);
  }
  const auto cost = static_cast<double>(sum / static_cast<Real>(2 * about_.size()));
  if (!std::isfinite(cost)) return {Status::invalid_input, 0.0};
  return {Status::ok, cost};
}

Evaluation PriorEvaluator::audit(const System& system) {
  const Evaluation result = evaluate<long double>(system);
  health_ = {};
  if (result.ok()) health_.cost_error = std::numeric_limits<double>::epsilon() * result.cost;
  return result;
}

Status PriorEvaluator::residuals(std::span<double> r) {
  for (std::size_t e = 0; e < r.size(); ++e) r[e] = root_ * logarithm_[e];
  return Status::ok;
}

Status PriorEvaluator::add_gradient(double weight, const SystemGradient& gradient) {
  const double factor = weight * root_ * root_;
  for (std::size_t e = 0; e < logarithm_.size(); ++e) gradient.stiffness[e] += factor * logarithm_[e] / stiffness_[e];
  return Status::ok;
}

Status PriorEvaluator::product(const System& direction, std::span<double> jv) {
  for (std::size_t e = 0; e < jv.size(); ++e) jv[e] = root_ * direction.stiffness[e] / stiffness_[e];
  return Status::ok;
}

Status PriorEvaluator::add_transposed_product(std::span<const double> w, const SystemGradient& gradient) {
  for (std::size_t e = 0; e < w.size(); ++e) gradient.stiffness[e] += root_ * w[e] / stiffness_[e];
  return Status::ok;
}

// In ln k every spring's residual has the same slope.
Status PriorEvaluator::jacobian(const Parameters& parameters, std::span<double> rows) {
  std::ranges::fill(rows, 0.0);
  for (std::size_t e = 0; e < logarithm_.size(); ++e) rows[e * parameters.size() + parameters.coordinate_of(e)] = root_;
  return Status::ok;
}

Moves* PriorEvaluator::moves() {
  if (!moves_) moves_ = std::make_unique<PriorMoves>(parameters_, about_);
  return moves_.get();
}

}  // namespace nodal::elastic
