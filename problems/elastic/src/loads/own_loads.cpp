// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/own_loads.h"

#include <algorithm>
#include <functional>
#include <span>

#include <fmt/format.h>

#include "loads/own_pulls.h"
#include "loads/own_supports.h"

namespace nodal::elastic {

namespace {

// What supports bear, and what adds up to nothing, pulls at no point.
bool some_at_free_nodes(std::span<const double> forces, const HeldFreedoms& held) {
  for (std::size_t f = 0; f < forces.size(); ++f)
    if (forces[f] != 0.0 && !held.contains(f)) return true;
  return false;
}

// Whether all of the forces, of which there are some, act where supports hold the nodes.
bool only_on_supports(std::span<const double> forces, const HeldFreedoms& held) {
  return !some_at_free_nodes(forces, held) && std::ranges::any_of(forces, [](double f) { return f != 0.0; });
}

[[noreturn]] void refuse_at_rest(const OwnCase& one, const Net& net, const HeldFreedoms& held) {
  std::size_t free = net.nodes.size() - 1;  // a node that the forces may pull down, so that the advice can be pasted
  while (free > 0 && held.contains(net.freedoms().at(free, 1))) --free;
  const std::string node = fmt::format("near = [{}, {}]", net.nodes[free][0], net.nodes[free][1]);
  throw InputError(
      one.source,
      fmt::format("nothing pulls or moves in load '{}': give it forces, as forces = [{{ {}, force = [0, -1] }}], {}"
                  "or supports that move, as {{ {}, displacement = [0.1, 0] }}",
                  one.load.name, node,
                  net.body.has_outline() ? "tractions, as tractions = [{ edge = \"right\", traction = [1, 0] }], a "
                                           "body_force, as body_force = [0, -1], "
                                         : "",
                  node));
}

OwnCase read_case(const Options& table, const Net& net, const MaterialField& material) {
  OwnCase result{{table.text("name"), std::vector<double>(net.freedoms().size(), 0.0)}, table.values().source};
  PlacedLoad& load = result.load;
  if (load.name.empty()) throw InputError(table.at("name").source, "the name of a load may not be empty");
  HeldFreedoms held;
  const auto note = [&](std::string selection) { result.selections.push_back(std::move(selection)); };
  for (const Options& support : table.tables("supports")) note(add_supports(support, net, held, load.body));
  const auto pull = [&](auto add) {
    std::vector<double> own(load.forces.size(), 0.0);
    note(add(own));
    if (only_on_supports(own, held)) result.idle.push_back(result.selections.back());
    std::ranges::transform(own, load.forces, load.forces.begin(), std::plus<>());
  };
  for (const Options& force : table.tables("forces"))
    pull([&](std::span<double> own) { return add_forces(force, net, own); });
  load.body.forces_on_nodes = some_at_free_nodes(load.forces, held);  // those so far
  for (const Options& traction : table.tables("tractions"))
    pull([&](std::span<double> own) { return add_tractions(traction, net, material, own, load.body); });
  if (table.has("body_force"))
    pull([&](std::span<double> own) { return add_body_force(table.at("body_force"), net, material, own, load.body); });
  bool moved = std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
  for (const auto& [freedom, hold] : held) {
    load.group.supports.push_back({net.freedoms().node_of(freedom), net.freedoms().axis_of(freedom), hold.value});
    if (hold.measured) load.held_as_reference.push_back(freedom);
    moved = moved || hold.measured || hold.value != 0.0;
  }
  load.body.points = points_of(load.body, load.group.supports, net);
  if (!moved) refuse_at_rest(result, net, held);
  return result;
}

}  // namespace

std::vector<OwnCase> read_own_cases(const std::vector<Options>& cases, const Net& net, const MaterialField& material) {
  std::vector<OwnCase> read;
  for (const Options& table : cases) {
    OwnCase one = read_case(table, net, material);
    const auto earlier =
        std::ranges::find_if(read, [&](const OwnCase& other) { return other.load.name == one.load.name; });
    if (earlier != read.end())
      throw InputError(one.source, fmt::format("two loads are called '{}'; the other one: {}", one.load.name,
                                               earlier->source.text()));
    read.push_back(std::move(one));
  }
  return read;
}

}  // namespace nodal::elastic
