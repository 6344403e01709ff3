// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/state.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/elastic/determination.h>

#include <nodal/show/at_bounds.h>
#include "displacements/findings.h"
#include "displacements/highest_frequency.h"
#include "displacements/nodal_stress.h"
#include "show/nodal_stress_text.h"
#include "show/state_tables.h"

namespace nodal::elastic::show {

namespace {

// A list per node.
Value by_node(const Freedoms& freedoms, const std::vector<double>& values) {
  Value::List list;
  for (std::size_t i = 0; i < freedoms.nodes; ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(freedoms.at(i, 0));
    list.emplace_back(Value::List(first, first + static_cast<std::ptrdiff_t>(freedoms.dimension)));
  }
  return Value(std::move(list));
}

Value index(std::size_t i) { return Value(static_cast<std::int64_t>(i)); }

Value node_name(const Net& net, std::size_t node) { return Value(net.id(node)); }

Value bearing_json(const Net& net, const LoadState& load) {
  Value::List list;
  for (std::size_t s = 0; s < load.supports.size(); ++s)
    list.emplace_back(
        Value::List{node_name(net, load.supports[s].node), index(load.supports[s].axis), Value(load.bearing[s])});
  return Value(std::move(list));
}

Value health_json(const Health& health) {
  Value table;
  if (health.error_estimate) table.set("error_estimate", *health.error_estimate);
  if (health.cost_error) table.set("cost_error", *health.cost_error);
  if (health.residual) table.set("residual", *health.residual);
  for (const Finding& finding : health.findings) table.set(finding.name, finding.value);
  return table;
}

Value names_json(const Net& net) {
  Value::List names;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) names.push_back(node_name(net, i));
  return Value(std::move(names));
}

std::vector<double> coordinates_at(const ElasticProblem& problem, std::span<const double> stiffness) {
  std::vector<double> x(problem.parameters().size());
  problem.parameters().coordinates(stiffness, x);
  return x;
}

Value at_bounds_json(const ElasticProblem& problem, std::span<const double> stiffness) {
  const AtBounds at = count_at_bounds(problem.space(), coordinates_at(problem, stiffness));
  Value table;
  table.set("coordinates", index(problem.space().size()));
  table.set("lower", index(at.lower));
  table.set("upper", index(at.upper));
  return table;
}

// The springs whose stiffness the reference says nothing about.
Value undetermined_json(const ElasticProblem& problem, std::span<const double> stiffness) {
  Value::List list;
  for (const std::size_t coordinate : determine(problem, stiffness).undetermined)
    for (const std::size_t e : problem.parameters().springs_of(coordinate))
      list.emplace_back(Value::List{node_name(problem.net(), problem.net().springs[e].first),
                                    node_name(problem.net(), problem.net().springs[e].second)});
  return Value(std::move(list));
}

Value prior_json(const PriorShare& prior) {
  Value table;
  table.set("weight", prior.weight);
  table.set("mean_square", prior.mean_square);
  table.set("cost", prior.cost);
  table.set("quality", prior.quality);
  return table;
}

Value load_json(const ElasticProblem& problem, const LoadState& load, const LoadCase& asked, const NodeVolumes& share,
                bool held_out) {
  const bool compared = problem.scene().has_reference;
  Value entry;
  entry.set("name", load.name);
  if (held_out) entry.set("relative_error", load.relative_error);
  if (compared) entry.set("quality", load.quality);
  entry.set("displacement", by_node(problem.net().freedoms(), load.displacement));
  if (compared) entry.set("reference", by_node(problem.net().freedoms(), load.reference));
  entry.set("force", Value(Value::List(load.spring_force.begin(), load.spring_force.end())));
  entry.set("bearing", bearing_json(problem.net(), load));
  if (!share.volumes.empty())
    entry.set("stress",
              stress_json(problem.net().dimension, nodal_stress(problem.net(), share.volumes, load.spring_force)));
  if (!asked.reference_stress.empty())
    entry.set("reference_stress", stress_json(problem.net().dimension, asked.reference_stress));
  return entry;
}

Value loads_json(const ElasticProblem& problem, const std::vector<LoadState>& states, const LoadSet& set,
                 const NodeVolumes& share, bool held_out) {
  Value::List loads;
  for (std::size_t l = 0; l < states.size(); ++l)
    loads.push_back(load_json(problem, states[l], set.loads[l], share, held_out));
  return Value(std::move(loads));
}

Value unseen_json(const ElasticProblem& problem, const State& state, const NodeVolumes& share) {
  Value unseen;
  if (!state.unseen_failure.empty()) {
    unseen.set("failure", state.unseen_failure);
    return unseen;
  }
  unseen.set("error", state.unseen_error);
  unseen.set("loads", loads_json(problem, state.unseen, problem.scene().held_out, share, true));
  return unseen;
}

double largest_magnitude(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

Value state_json(const std::string& label, const ElasticProblem& problem, std::span<const double> stiffness,
                 const State& state) {
  const NodeVolumes share = node_volumes(problem.net(), problem.scene().material);
  Value::List springs;
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    const Spring& spring = problem.net().springs[e];
    Value entry;
    entry.set("nodes",
              Value(Value::List{node_name(problem.net(), spring.first), node_name(problem.net(), spring.second)}));
    entry.set("stiffness", stiffness[e]);
    springs.push_back(std::move(entry));
  }
  Value result;
  result.set("problem", label);
  result.set("nodes", index(problem.net().nodes.size()));
  result.set("node_names", names_json(problem.net()));
  result.set("springs", Value(std::move(springs)));
  if (problem.scene().has_reference) {
    result.set("at_bounds", at_bounds_json(problem, stiffness));
    result.set("quality", state.quality);
    result.set("relative_error", state.relative_error);
  }
  if (state.prior) result.set("prior", prior_json(*state.prior));
  result.set("loads", loads_json(problem, state.loads, problem.scene().loads, share, false));
  if (!share.volumes.empty()) result.set("stress_over", share.shared);
  if (!problem.held_out().empty()) result.set("unseen", unseen_json(problem, state, share));
  result.set("health", health_json(state.health));
  if (stable_step_of(problem.net(), stiffness))
    result.set("stable_step_estimate", 2.0 / highest_frequency_estimate(problem.net(), stiffness));
  if (Value undetermined = undetermined_json(problem, stiffness); !undetermined.list().empty())
    result.set("undetermined", std::move(undetermined));
  if (Value details = problem.details(); !details.table().empty()) result.set("details", std::move(details));
  return result;
}

namespace {

std::string accuracy_text(const Health& health) {
  if (!health.error_estimate || !health.residual) return {};
  return fmt::format("accuracy: first refinement step {:.1e}, cost exact to {:.1e}, backward error {:.1e}\n",
                     *health.error_estimate, health.cost_error.value_or(0.0), *health.residual);
}

// Loads that are held out: how wrong the system is where nothing was fitted.
std::string unseen_text(const ElasticProblem& problem, const State& state) {
  if (problem.held_out().empty()) return {};
  if (!state.unseen_failure.empty())
    return fmt::format("unseen error: the loads that are never fitted can't be solved: {}\n", state.unseen_failure);
  const auto worst = std::ranges::max_element(state.unseen, {}, &LoadState::relative_error);
  if (state.unseen.size() == 1)
    return fmt::format("unseen error {:.6g} (of {}, which is never fitted)\n", state.unseen_error, worst->name);
  return fmt::format("unseen error {:.6g} (root mean square of {} loads that are never fitted; worst: {}, {:.6g})\n",
                     state.unseen_error, state.unseen.size(), worst->name, worst->relative_error);
}

std::string unseen_table(const State& state) {
  if (state.unseen.empty()) return {};
  std::string text = fmt::format("\n{:<12} {:>14} {:>14} {:>24} {:>26}\n", "never fitted", "relative error", "G",
                                 "largest displacement [m]", "largest bearing force [N]");
  for (const LoadState& load : state.unseen)
    text += fmt::format("{:<12} {:>14.6g} {:>14.6g} {:>24.6g} {:>26.6g}\n", load.name, load.relative_error,
                        load.quality, largest_magnitude(load.displacement), largest_magnitude(load.bearing));
  return text;
}

std::string stable_step_text(const ElasticProblem& problem, std::span<const double> stiffness) {
  const std::optional<double> step = stable_step_of(problem.net(), stiffness);
  if (!step) return {};
  return fmt::format(
      "explicit integration in time is stable below {:.4g} s by a bound of frequencies; by an estimate below {:.4g} "
      "s\n",
      *step, 2.0 / highest_frequency_estimate(problem.net(), stiffness));
}

// What is compared with the reference: errors, and what a fit would make of these stiffnesses.
std::string compared_text(const ElasticProblem& problem, std::span<const double> stiffness, const State& state) {
  std::string text = fmt::format("relative error {:.6g}, G {:.10g}, k_max/k_min {:.4g}\n", state.relative_error,
                                 state.quality, spread_of(stiffness));
  if (const std::optional<PriorShare>& prior = state.prior)
    text += fmt::format("prior of weight {:g}: ln(k/k_start) is {:.4g} in the root mean square; a fit sees G {:.10g}\n",
                        prior->weight, std::sqrt(prior->mean_square), prior->quality);
  text += unseen_text(problem, state);
  text += stable_step_text(problem, stiffness);
  text += accuracy_text(state.health);
  if (problem.reference_error())
    text +=
        fmt::format("the reference, by finite elements, may be off by {:.2g}: a relative error below that is none\n",
                    *problem.reference_error());
  text += fmt::format("{} ({})\n", at_bounds_text(problem.space(), coordinates_at(problem, stiffness)),
                      describe(problem.scene().stiffness_bounds));
  if (const std::string note = describe(determine(problem, stiffness), problem); !note.empty())
    text += "note: " + note + "\n";
  text += fmt::format("\n{:<12} {:>14} {:>24} {:>26}\n", "load", "G", "largest displacement [m]",
                      "largest bearing force [N]");
  for (const LoadState& load : state.loads)
    text += fmt::format("{:<12} {:>14.6g} {:>24.6g} {:>26.6g}\n", load.name, load.quality,
                        largest_magnitude(load.displacement), largest_magnitude(load.bearing));
  return text + unseen_table(state) + stress_table(problem, state);
}

}  // namespace

std::string state_text(const std::string& label, const ElasticProblem& problem, std::span<const double> stiffness,
                       const State& state) {
  std::string text =
      fmt::format("{}: {} nodes, {} springs\n", label, problem.net().nodes.size(), problem.net().springs.size());
  if (problem.scene().has_reference) return text + compared_text(problem, stiffness, state);
  text += fmt::format("no reference to compare with; k_max/k_min {:.4g}\n", spread_of(stiffness));
  text += stable_step_text(problem, stiffness);
  text += accuracy_text(state.health);
  for (const LoadState& load : state.loads) text += state_tables(problem.net(), load);
  return text + stress_table(problem, state);
}

}  // namespace nodal::elastic::show
