// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/nodal_stress_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace nodal::elastic::show {

namespace {

std::string line_of(const Net& net, const LoadState& load, const std::vector<Tensor>& reference,
                    const NodeVolumes& share) {
  const std::vector<Tensor> stress = nodal_stress(net, share.volumes, load.spring_force);
  const auto worst = static_cast<std::size_t>(
      std::ranges::max_element(stress, {}, [](const Tensor& t) { return von_mises(t); }) - stress.begin());
  return fmt::format("{:<12} {:>30.6g} {:>10} {:>10} {:>22}\n", load.name, von_mises(stress[worst]), net.id(worst),
                     net.on_border(worst) ? "border" : "inside",
                     reference.empty() ? "" : fmt::format("{:.6g}", von_mises(reference[worst])));
}

}  // namespace

Value stress_json(std::size_t dimension, const std::vector<Tensor>& stress) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kVoigt = {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};
  Value::List list;
  for (const Tensor& t : stress) {
    Value::List components;
    for (const auto& [a, b] : kVoigt)
      if (std::max(a, b) < dimension) components.emplace_back(t[a][b]);
    list.emplace_back(std::move(components));
  }
  return Value(std::move(list));
}

std::string stress_table(const ElasticProblem& problem, const State& state) {
  const Net& net = problem.net();
  const NodeVolumes share = node_volumes(net, problem.scene().material);
  if (share.volumes.empty()) return {};
  std::string text = fmt::format("\n{:<12} {:>30} {:>10} {:>10} {:>22}\n", "stress", "largest von Mises stress [Pa]",
                                 "at node", "where", "reference there [Pa]");
  const auto add = [&](const std::vector<LoadState>& states, const LoadSet& set) {
    for (std::size_t l = 0; l < states.size(); ++l)
      text += line_of(net, states[l], set.loads[l].reference_stress, share);
  };
  add(state.loads, problem.scene().loads);
  add(state.unseen, problem.scene().held_out);
  return text + fmt::format(
                    "(of springs, over {}: those on the border are cut by it, and their stress is a mean over "
                    "a part as deep as half a spring)\n",
                    share.shared);
}

}  // namespace nodal::elastic::show
