// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_state.h"

#include <cmath>

#include <fmt/format.h>

namespace nodal {

namespace {

Value pairs(const std::vector<double>& values) {
  Value::List list;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2)
    list.emplace_back(Value::List{Value(values[i]), Value(values[i + 1])});
  return Value(std::move(list));
}

Value index(std::size_t i) { return Value(static_cast<std::int64_t>(i)); }

Value node_name(const elastic::Net& net, std::size_t node) { return Value(net.id(node)); }

Value bearing_json(const elastic::Net& net, const elastic::LoadState& load) {
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
  if (health.spread) table.set("spread", *health.spread);
  return table;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

}  // namespace

Value state_json(const std::string& label, const elastic::ElasticProblem& problem, std::span<const double> stiffness,
                 const elastic::State& state) {
  Value::List springs, loads;
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    const elastic::Spring& spring = problem.net().springs[e];
    Value entry;
    entry.set("nodes",
              Value(Value::List{node_name(problem.net(), spring.first), node_name(problem.net(), spring.second)}));
    entry.set("stiffness", stiffness[e]);
    springs.push_back(std::move(entry));
  }
  for (const elastic::LoadState& load : state.loads) {
    Value entry;
    entry.set("name", load.name);
    entry.set("quality", load.quality);
    entry.set("displacement", pairs(load.displacement));
    entry.set("reference", pairs(load.reference));
    entry.set("bearing", bearing_json(problem.net(), load));
    loads.push_back(std::move(entry));
  }
  Value result;
  result.set("problem", label);
  result.set("nodes", index(problem.net().nodes.size()));
  result.set("springs", Value(std::move(springs)));
  result.set("quality", state.quality);
  result.set("relative_error", state.relative_error);
  result.set("loads", Value(std::move(loads)));
  result.set("health", health_json(state.health));
  if (Value details = problem.details(); !details.table().empty()) result.set("details", std::move(details));
  return result;
}

std::string state_text(const std::string& label, const elastic::ElasticProblem& problem, const elastic::State& state) {
  std::string text =
      fmt::format("{}: {} nodes, {} springs\n", label, problem.net().nodes.size(), problem.net().springs.size());
  text += fmt::format("relative error {:.6g}, G {:.10g}, k_max/k_min {:.4g}\n", state.relative_error, state.quality,
                      state.health.spread.value_or(1.0));
  if (state.health.error_estimate && state.health.residual)
    text += fmt::format("accuracy: first refinement step {:.1e}, cost exact to {:.1e}, backward error {:.1e}\n",
                        *state.health.error_estimate, state.health.cost_error.value_or(0.0), *state.health.residual);
  text += fmt::format("\n{:<12} {:>14} {:>24} {:>26}\n", "load", "G", "largest displacement [m]",
                      "largest bearing force [N]");
  for (const elastic::LoadState& load : state.loads)
    text += fmt::format("{:<12} {:>14.6g} {:>24.6g} {:>26.6g}\n", load.name, load.quality, largest(load.displacement),
                        largest(load.bearing));
  return text;
}

}  // namespace nodal
