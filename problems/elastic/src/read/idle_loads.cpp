// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/idle_loads.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

bool moves(const LoadCase& load, const SupportGroup& group, const Freedoms& freedoms) {
  std::vector<bool> held(load.forces.size(), false);
  for (const Support& s : group.supports) {
    if (s.value != 0.0) return true;
    held[freedoms.at(s.node, s.axis)] = true;
  }
  for (std::size_t f = 0; f < held.size(); ++f)
    if (!held[f] && load.forces[f] != 0.0) return true;
  return false;
}

}  // namespace

void tell_of_idle_loads(const std::vector<OwnCase>& cases, const Scene& scene, Account& account) {
  for (std::size_t l = 0; l < cases.size(); ++l) {
    const OwnCase& one = cases[l];
    const LoadCase& load = scene.loads.loads[l];
    if (moves(load, scene.loads.groups[load.group], scene.net.freedoms())) {
      for (const std::string& idle : one.idle)
        account.finding(
            fmt::format("load '{}': {}, but only where supports hold: they bear all of it, and nothing moves by it",
                        one.load.name, idle));
      continue;
    }
    const bool pulled = std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
    const std::string why = fmt::format(
        "nothing moves in load '{}': {}", one.load.name,
        !pulled            ? "its supports are held as measured, which is at rest, and nothing pulls"
        : one.idle.empty() ? "what pulls acts only where supports hold, and they bear all of it"
                           : fmt::format("what pulls acts only where supports hold, and they bear all of it ({})",
                                         fmt::join(one.idle, "; ")));
    if (!scene.has_reference) {
      account.finding(why + "; all displacements and spring forces are 0");
      continue;
    }
    throw InputError(one.source, why +
                                     ", so no stiffness can fit its reference; pull at nodes that are free to move, or "
                                     "leave the load out");
  }
}

}  // namespace nodal::elastic
