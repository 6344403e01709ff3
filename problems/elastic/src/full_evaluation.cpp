// SPDX-License-Identifier: GPL-3.0-or-later
#include "full_evaluation.h"

#include <algorithm>

#include <fmt/format.h>

namespace nodal::elastic {

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
                         failed.failed_node(), failed_group_);
    case Status::ill_conditioned:
      return fmt::format(
          "stiffnesses differ too much for double precision, among each other or from what the loads ask for; node {} "
          "suffers most (support group {})",
          failed.weakest_node(), failed_group_);
    default:
      return {};
  }
}

Work FullEvaluation::work() const {
  Work total;
  for (const auto& equilibrium : equilibria_) total += equilibrium->work();
  return total;
}

}  // namespace nodal::elastic
