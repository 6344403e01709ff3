// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/load_states.h"

#include <cmath>

#include <fmt/format.h>

#include <nodal/unseen.h>

namespace nodal::elastic {

namespace {

// What a solved load looks like. F^b = K u − F^e on the fixed freedoms, summed by springs.
LoadState state_of(const ElasticModel& model, const Equilibrium& equilibrium, std::size_t l,
                   std::span<const double> stiffness) {
  const EquilibriumGroup& group = equilibrium.group();
  const Scene& scene = model.scene;
  const LoadCase& load = scene.loads.loads[group.loads()[l].index];
  const double unit = model.displacement_unit;
  const std::span<const double> placed = equilibrium.displacement(l);
  std::vector<double> force(group.freedoms(), 0.0);
  LoadState out;
  for (std::size_t e = 0; e < group.springs(); ++e) {
    const double pull = stiffness[e] * group.elongation(e, placed.data());
    group.add_spring(e, pull, force.data());
    out.spring_force.push_back(pull * unit);
  }
  out.name = load.name;
  if (scene.has_reference) {
    out.quality = std::sqrt(squared_error(group, l, placed.data())) * unit;
    out.reference = load.reference;
  }
  out.displacement.resize(group.freedoms());
  for (std::size_t i = 0; i < group.freedoms(); ++i) out.displacement[i] = placed[group.place()[i]] * unit;
  out.supports = group.supports();
  for (const Support& s : group.supports()) {
    const std::size_t freedom = scene.net.freedoms().at(s.node, s.axis);
    out.bearing.push_back(force[group.place()[freedom]] * unit - load.forces[freedom]);
  }
  return out;
}

}  // namespace

std::vector<LoadState> load_states(const ElasticModel& model, const FullEvaluation& evaluation,
                                   std::span<const double> stiffness) {
  std::vector<LoadState> states(model.scene.loads.loads.size());
  std::vector<double> errors(states.size());
  evaluation.load_errors(errors);
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    const std::vector<EquilibriumGroup::Load>& loads = model.groups[g]->loads();
    for (std::size_t l = 0; l < loads.size(); ++l) {
      LoadState& state = states[loads[l].index] = state_of(model, evaluation.group(g), l, stiffness);
      state.relative_error = errors[loads[l].index];
    }
  }
  return states;
}

void add_unseen(const ElasticModel& model, std::span<const double> stiffness, State& state) {
  FullEvaluation evaluation(model);
  if (const Status status = evaluation.solve(stiffness, true); status != Status::ok) {
    state.unseen_failure = fmt::format("{}: {}", to_string(status), evaluation.describe(status));
    return;
  }
  state.unseen = load_states(model, evaluation, stiffness);
  std::vector<double> errors;
  for (const LoadState& load : state.unseen) errors.push_back(load.relative_error);
  state.unseen_error = unseen_error(errors);
}

}  // namespace nodal::elastic
