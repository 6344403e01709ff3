// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/full_evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// Right-hand sides that the Jacobian solves for at once: enough for CHOLMOD to gain, few enough to stay in cache.
constexpr std::size_t kJacobianColumns = 32;

}  // namespace

FullEvaluation::FullEvaluation(const ElasticModel& model) : model_(model) {
  for (const auto& group : model.groups) equilibria_.push_back(std::make_unique<Equilibrium>(*group));
}

Status FullEvaluation::solve(std::span<const double> stiffness, bool refined) {
  stiffness_ = stiffness;
  failed_group_ = 0;
  if (refined) health_ = {};
  if (!std::ranges::all_of(stiffness, usable_stiffness)) return Status::invalid_input;
  double squared = 0.0, error_squared = 0.0;
  Health health;
  for (std::size_t g = 0; g < equilibria_.size(); ++g) {
    Equilibrium& equilibrium = *equilibria_[g];
    failed_group_ = g;
    if (const Status status = equilibrium.factorize(stiffness); status != Status::ok) return status;
    if (const Status status = equilibrium.solve_loads(); status != Status::ok)
      return refuse(status, equilibrium.first_correction(), refined);
    if (refined) {
      const Refinement refinement = equilibrium.refine();
      health.error_estimate = std::max(health.error_estimate.value_or(0.0), refinement.error_estimate);
      health.residual = std::max(health.residual.value_or(0.0), refinement.residual);
      error_squared += refinement.error_squared;
      if (refinement.status != Status::ok) return refuse(refinement.status, refinement.error_estimate, refined);
    }
    for (std::size_t l = 0; l < equilibrium.group().loads().size(); ++l)
      squared += squared_error(equilibrium.group(), l, equilibrium.displacement(l).data());
  }
  if (!std::isfinite(squared)) return Status::ill_conditioned;
  squared_ = squared;
  if (refined) {
    health.cost_error = model_.cost_error(model_.cost(squared), error_squared);
    health_ = health;
  }
  return Status::ok;
}

void FullEvaluation::load_errors(std::span<double> errors) const {
  for (const auto& equilibrium : equilibria_) {
    const EquilibriumGroup& group = equilibrium->group();
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const std::size_t load = group.loads()[l].index;
      const double error = std::sqrt(squared_error(group, l, equilibrium->displacement(l).data()));
      errors[load] = model_.reference_norms[load] > 0.0 ? error / model_.reference_norms[load] : 0.0;
    }
  }
}

// What a refined solve that is refused leaves in its health: how much was lost.
Status FullEvaluation::refuse(Status status, double error_estimate, bool refined) {
  if (refined && std::isfinite(error_estimate)) health_.error_estimate = error_estimate;
  return status;
}

std::string FullEvaluation::describe(Status status) const {
  const Equilibrium& failed = *equilibria_[failed_group_];
  switch (status) {
    case Status::invalid_input: {
      if (!failed.group().flaw().empty()) return failed.group().flaw();
      const auto bad = std::ranges::find_if_not(stiffness_, usable_stiffness);
      const Spring& s = model_.scene.net.springs[static_cast<std::size_t>(bad - stiffness_.begin())];
      return fmt::format("spring ({}, {}) has stiffness {}, which can't be computed with", s.first, s.second, *bad);
    }
    case Status::not_positive_definite:
      return fmt::format("the net is a mechanism or not supported: it gives way at node {} (support group {})",
                         model_.scene.net.id(failed.failed_node()), failed_group_);
    case Status::ill_conditioned:
      return fmt::format(
          "stiffnesses differ too much for double precision, among each other or from what the loads ask for; node {} "
          "suffers most (support group {})",
          model_.scene.net.id(failed.weakest_node()), failed_group_);
    default:
      return {};
  }
}

void FullEvaluation::residuals(std::span<double> residuals) {
  const double scale = 1.0 / model_.reference_norm;
  for (const auto& solved : equilibria_) {
    Equilibrium& equilibrium = *solved;
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
void FullEvaluation::add_adjoint(Equilibrium& equilibrium, std::span<double> by_spring) {
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

void FullEvaluation::add_gradient(std::span<double> by_spring) {
  for (const auto& solved : equilibria_) {
    Equilibrium& equilibrium = *solved;
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* u = equilibrium.displacement(l).data();
      const double* reference = group.loads()[l].reference.data();
      double* column = rhs.data() + l * group.free();
      for (std::size_t i = 0; i < group.free(); ++i) column[i] = group.weights()[i] * (u[i] - reference[i]);
    }
    add_adjoint(equilibrium, by_spring);
  }
}

void FullEvaluation::product(std::span<const double> factor, std::span<double> jv) {
  for (const auto& solved : equilibria_) {
    Equilibrium& equilibrium = *solved;
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    const std::span<double> sum = equilibrium.scratch();
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* u = equilibrium.displacement(l).data();
      std::ranges::fill(sum, 0.0);
      for (std::size_t e = 0; e < stiffness_.size(); ++e)
        group.add_spring(e, -factor[e] * group.elongation(e, u), sum.data());
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
}

void FullEvaluation::add_transposed_product(std::span<const double> w, std::span<double> by_spring) {
  for (const auto& solved : equilibria_) {
    Equilibrium& equilibrium = *solved;
    const EquilibriumGroup& group = equilibrium.group();
    const std::span<double> rhs = equilibrium.factor().right_hand_side(group.loads().size());
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const double* row = w.data() + model_.first_residual[group.loads()[l].index];
      double* column = rhs.data() + l * group.free();
      for (std::size_t i = 0; i < group.free(); ++i)
        column[i] = std::sqrt(group.weights()[i]) * row[group.residual_at(i)] / model_.reference_norm;
    }
    add_adjoint(equilibrium, by_spring);
  }
}

void FullEvaluation::add_jacobian(std::span<double> jacobian) {
  for (const auto& equilibrium : equilibria_)
    for (std::size_t begin = 0; begin < stiffness_.size(); begin += kJacobianColumns)
      add_jacobian_columns(*equilibrium, begin, std::min(begin + kJacobianColumns, stiffness_.size()), jacobian);
}

void FullEvaluation::add_jacobian_columns(Equilibrium& equilibrium, std::size_t begin, std::size_t end,
                                          std::span<double> jacobian) {
  const EquilibriumGroup& group = equilibrium.group();
  const std::size_t free = group.free(), count = end - begin, width = model_.parameters.size();
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

Work FullEvaluation::work() const {
  Work total;
  for (const auto& equilibrium : equilibria_) total += equilibrium->work();
  return total;
}

}  // namespace nodal::elastic
