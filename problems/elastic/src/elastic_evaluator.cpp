// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_evaluator.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "moves/elastic_moves.h"

namespace nodal::elastic {

namespace {

// Right-hand sides that the Jacobian solves for at once: enough for CHOLMOD to gain, few enough to stay in cache.
constexpr std::size_t kJacobianColumns = 32;

void require_size(std::size_t actual, std::size_t wanted, const char* what) {
  if (actual != wanted)
    throw std::invalid_argument(fmt::format("{} has {} entries; the elastic problem needs {}", what, actual, wanted));
}

}  // namespace

ElasticEvaluator::ElasticEvaluator(const ElasticModel& model)
    : model_(model),
      full_(model),
      x_(model.parameters.size()),
      stiffness_(model.parameters.springs()),
      by_spring_(model.parameters.springs()) {}

ElasticEvaluator::~ElasticEvaluator() = default;

Evaluation ElasticEvaluator::evaluate_stiffness(bool refined) {
  at_point_ = false;
  const Status status = full_.solve(stiffness_, refined);
  if (refined) health_ = full_.health();
  if (status != Status::ok) return {status, 0.0};
  at_point_ = true;
  refined_ = refined;
  cost_ = model_.cost(full_.squared());
  return {Status::ok, cost_};
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
  if (result.ok()) {
    const auto [softest, stiffest] = std::ranges::minmax(stiffness_);
    health_.spread = stiffest / softest;
  }
  return result;
}

Evaluation ElasticEvaluator::solve_refined(std::span<const double> stiffness, std::string& message) {
  require_size(stiffness.size(), stiffness_.size(), "stiffness");
  std::ranges::copy(stiffness, stiffness_.begin());
  const Evaluation result = evaluate_stiffness(true);
  at_point_ = false;  // there need not be an x for these stiffnesses
  if (!result.ok()) message = full_.describe(result.status);
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
  if (result.ok()) write_residuals(residuals);
  return result;
}

Evaluation ElasticEvaluator::residuals_and_jacobian(std::span<const double> x, std::span<double> residuals_out,
                                                    std::span<double> jacobian_out) {
  Evaluation result = residuals(x, residuals_out);
  if (result.ok()) result.status = jacobian(jacobian_out);
  return result;
}

void ElasticEvaluator::write_residuals(std::span<double> residuals) {
  const double scale = 1.0 / model_.reference_norm;
  for (std::size_t g = 0; g < full_.groups(); ++g) {
    Equilibrium& equilibrium = full_.group(g);
    const EquilibriumGroup& group = equilibrium.group();
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const EquilibriumGroup::Load& load = group.loads()[l];
      const double* u = equilibrium.displacement(l).data();
      double* row = residuals.data() + model_.first_residual[load.index];
      for (std::size_t i = 0; i < group.free(); ++i)
        row[group.residual_at(i)] = scale * std::sqrt(group.weights()[i]) * (u[i] - load.reference[i]);
    }
  }
}

// Solves K p = rhs, the right-hand sides of all loads standing ready, and adds −(b_e·p)(b_e·u) to each spring.
void ElasticEvaluator::add_adjoint(Equilibrium& equilibrium, std::span<double> by_spring) {
  const EquilibriumGroup& group = equilibrium.group();
  const std::span<const double> solution = equilibrium.solve(group.loads().size());
  const std::span<double> p = equilibrium.scratch();  // with zeros on the fixed freedoms
  for (std::size_t l = 0; l < group.loads().size(); ++l) {
    std::copy_n(solution.data() + l * group.free(), group.free(), p.data());
    const double* u = equilibrium.displacement(l).data();
    for (std::size_t e = 0; e < by_spring.size(); ++e)
      by_spring[e] -= group.elongation(e, p.data()) * group.elongation(e, u);
  }
}

Status ElasticEvaluator::gradient(std::span<double> gradient) {
  require_point();
  require_size(gradient.size(), x_.size(), "gradient");
  std::ranges::fill(by_spring_, 0.0);
  for (std::size_t g = 0; g < full_.groups(); ++g) {
    Equilibrium& equilibrium = full_.group(g);
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* u = equilibrium.displacement(l).data();
      const double* reference = group.loads()[l].reference.data();
      double* column = rhs.data() + l * group.free();
      for (std::size_t i = 0; i < group.free(); ++i) column[i] = group.weights()[i] * (u[i] - reference[i]);
    }
    add_adjoint(equilibrium, by_spring_);
  }
  for (double& entry : by_spring_) entry *= model_.inverse_reference_squared;
  model_.parameters.chain(stiffness_, by_spring_, gradient);
  return Status::ok;
}

Status ElasticEvaluator::jacobian(std::span<double> jacobian) {
  require_point();
  require_size(jacobian.size(), model_.residual_count * x_.size(), "jacobian");
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t g = 0; g < full_.groups(); ++g)
    for (std::size_t begin = 0; begin < stiffness_.size(); begin += kJacobianColumns)
      add_jacobian_columns(g, begin, std::min(begin + kJacobianColumns, stiffness_.size()), jacobian);
  return Status::ok;
}

void ElasticEvaluator::add_jacobian_columns(std::size_t g, std::size_t begin, std::size_t end,
                                            std::span<double> jacobian) {
  Equilibrium& equilibrium = full_.group(g);
  const EquilibriumGroup& group = equilibrium.group();
  const std::size_t free = group.free(), count = end - begin, width = x_.size();
  const std::span<double> rhs = equilibrium.factor().right_hand_side(count);
  const std::span<double> b = equilibrium.scratch();
  for (std::size_t c = 0; c < count; ++c) {
    group.add_spring(begin + c, 1.0, b.data());
    std::copy_n(b.data(), free, rhs.data() + c * free);
    group.clear_spring(begin + c, b.data());
  }
  const std::span<const double> z = equilibrium.solve(count);
  std::array<double, kJacobianColumns> factor{};
  for (std::size_t l = 0; l < group.loads().size(); ++l) {
    const double* u = equilibrium.displacement(l).data();
    for (std::size_t c = 0; c < count; ++c)
      factor[c] = -stiffness_[begin + c] * group.elongation(begin + c, u) / model_.reference_norm;
    for (std::size_t i = 0; i < free; ++i) {
      const double root = std::sqrt(group.weights()[i]);
      double* row = jacobian.data() + (model_.first_residual[group.loads()[l].index] + group.residual_at(i)) * width;
      for (std::size_t c = 0; c < count; ++c)
        row[model_.parameters.coordinate_of(begin + c)] += root * factor[c] * z[c * free + i];
    }
  }
}

Status ElasticEvaluator::jacobian_product(std::span<const double> v, std::span<double> jv) {
  require_point();
  require_size(v.size(), x_.size(), "v");
  require_size(jv.size(), model_.residual_count, "jv");
  for (std::size_t g = 0; g < full_.groups(); ++g) {
    Equilibrium& equilibrium = full_.group(g);
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    const std::span<double> sum = equilibrium.scratch();
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* u = equilibrium.displacement(l).data();
      std::ranges::fill(sum, 0.0);
      for (std::size_t e = 0; e < stiffness_.size(); ++e)
        group.add_spring(e, -stiffness_[e] * v[model_.parameters.coordinate_of(e)] * group.elongation(e, u),
                         sum.data());
      std::copy_n(sum.data(), group.free(), rhs.data() + l * group.free());
    }
    std::ranges::fill(sum, 0.0);
    const std::span<const double> du = equilibrium.solve(group.loads().size());
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      double* row = jv.data() + model_.first_residual[group.loads()[l].index];
      for (std::size_t i = 0; i < group.free(); ++i)
        row[group.residual_at(i)] = std::sqrt(group.weights()[i]) * du[l * group.free() + i] / model_.reference_norm;
    }
  }
  return Status::ok;
}

Status ElasticEvaluator::jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) {
  require_point();
  require_size(w.size(), model_.residual_count, "w");
  require_size(jtw.size(), x_.size(), "jtw");
  std::ranges::fill(by_spring_, 0.0);
  for (std::size_t g = 0; g < full_.groups(); ++g) {
    Equilibrium& equilibrium = full_.group(g);
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* row = w.data() + model_.first_residual[group.loads()[l].index];
      double* column = rhs.data() + l * group.free();
      for (std::size_t i = 0; i < group.free(); ++i)
        column[i] = std::sqrt(group.weights()[i]) * row[group.residual_at(i)] / model_.reference_norm;
    }
    add_adjoint(equilibrium, by_spring_);
  }
  model_.parameters.chain(stiffness_, by_spring_, jtw);
  return Status::ok;
}

Moves* ElasticEvaluator::moves() {
  if (!moves_) moves_ = std::make_unique<ElasticMoves>(model_);
  return moves_.get();
}

Work ElasticEvaluator::work() const {
  Work total = full_.work();
  if (moves_) total += moves_->work();
  return total;
}

}  // namespace nodal::elastic
