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
  if (!std::ranges::all_of(stiffness, usable_stiffness)) return Status::invalid_input;
  double squared = 0.0;
  Health health;
  for (std::size_t g = 0; g < equilibria_.size(); ++g) {
    Equilibrium& equilibrium = *equilibria_[g];
    failed_group_ = g;
    if (const Status status = equilibrium.factorize(stiffness); status != Status::ok) return status;
    if (const Status status = equilibrium.solve_loads(); status != Status::ok) return status;
    if (refined) {
      const Refinement refinement = equilibrium.refine();
      health.error_estimate = std::max(health.error_estimate.value_or(0.0), refinement.error_estimate);
      health.residual = std::max(health.residual.value_or(0.0), refinement.residual);
      if (refinement.status != Status::ok) return refinement.status;
    }
    for (std::size_t l = 0; l < equilibrium.group().loads().size(); ++l)
      squared += squared_error(equilibrium.group(), l, equilibrium.displacement(l).data());
  }
  if (!std::isfinite(squared)) return Status::ill_conditioned;
  if (refined) health_ = health;
  squared_ = squared;
  return Status::ok;
}

std::string FullEvaluation::describe(Status status) const {
  switch (status) {
    case Status::invalid_input: {
      const auto bad = std::ranges::find_if_not(stiffness_, usable_stiffness);
      const Spring& s = model_.scene.net.springs[static_cast<std::size_t>(bad - stiffness_.begin())];
      return fmt::format("spring ({}, {}) has stiffness {}, which can't be computed with", s.first, s.second, *bad);
    }
    case Status::not_positive_definite:
      return fmt::format("the net is a mechanism or not supported: it gives way at node {} (support group {})",
                         equilibria_[failed_group_]->failed_node(), failed_group_);
    case Status::ill_conditioned:
      return fmt::format("stiffnesses differ too much for double precision (support group {})", failed_group_);
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
