// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include <fmt/format.h>

#include "loads/closed_form.h"
#include "loads/held_nodes.h"
#include "loads/load_set_builder.h"
#include "loads/placed_load.h"

namespace nodal::elastic {

namespace {

void require_closed_form(const LoadSpec& spec) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const bool towards = (a == spec.axis) != (b == spec.axis);
      const bool borne = spec.hold == Hold::sliding ? a == b : spec.hold == Hold::clamped ? towards : true;
      if (spec.stress[a][b] != 0.0 && !borne)
        throw std::invalid_argument(fmt::format("load '{}' has no closed form under its supports", spec.name));
    }
  if (!is_homogeneous(spec.gradient) && spec.hold != Hold::resting)
    throw std::invalid_argument(fmt::format("load '{}' has no closed form but at rest", spec.name));
  if (!in_equilibrium(spec.gradient))
    throw std::invalid_argument(fmt::format("the stress of load '{}' is not in equilibrium", spec.name));
}

}  // namespace

std::vector<double> closed_form(const LoadSpec& spec, const Net& net, const Elasticity& elasticity) {
  require_closed_form(spec);
  const HeldNodes held = held_nodes(spec, net);
  if (spec.hold != Hold::resting) return displacements_on_a_side(net, elasticity, spec.stress, spec.axis, held.origin);
  if (is_homogeneous(spec.gradient)) return displacements_at_rest(net, elasticity, spec.stress, held.rest);
  return displacements_at_rest(net, elasticity, {spec.stress, spec.gradient, centre_of(net.body)}, held.rest);
}

std::string why_no_closed_form(const LoadSpec&, const Material&, std::size_t) { return {}; }

LoadSet discretize(const std::vector<LoadSpec>& specs, const Net& net, const Material& material) {
  LoadSetBuilder set(net.freedoms());
  for (const LoadSpec& spec : specs) {
    PlacedLoad placed = place(spec, net);
    std::vector<double> reference = closed_form(spec, net, material.elasticity(net.dimension));
    hold_as_reference(placed, reference, net.freedoms());
    set.add(spec.name, std::move(placed.forces), std::move(reference), std::move(placed.group));
  }
  return std::move(set).finish();
}

}  // namespace nodal::elastic
