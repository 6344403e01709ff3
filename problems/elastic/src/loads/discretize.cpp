// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include <fmt/format.h>

#include "loads/closed_form.h"
#include "loads/held_nodes.h"
#include "loads/load_set_builder.h"
#include "loads/placed_load.h"

namespace nodal::elastic {

std::vector<double> closed_form(const LoadSpec& spec, const Net& net, const MaterialField& material) {
  if (const std::string why = why_no_closed_form(spec, material, net.dimension); !why.empty())
    throw std::invalid_argument(fmt::format("load '{}' has no closed form: {}", spec.name, why));
  const Elasticity elasticity = material.homogeneous()->elasticity(net.dimension);
  const HeldNodes held = held_nodes(spec, net);
  if (spec.hold != Hold::resting) return displacements_on_a_side(net, elasticity, spec.stress, spec.axis, held.origin);
  if (is_homogeneous(spec.gradient)) return displacements_at_rest(net, elasticity, spec.stress, held.rest);
  return displacements_at_rest(net, elasticity, {spec.stress, spec.gradient, centre_of(net.body)}, held.rest);
}

LoadSet discretize(const std::vector<LoadSpec>& specs, const Net& net, const MaterialField& material) {
  LoadSetBuilder set(net.freedoms());
  for (const LoadSpec& spec : specs) {
    PlacedLoad placed = place(spec, net);
    std::vector<double> reference = closed_form(spec, net, material);
    hold_as_reference(placed, reference, net.freedoms());
    set.add(load_case(std::move(placed), std::move(reference)), std::move(placed.group));
  }
  return std::move(set).finish();
}

}  // namespace nodal::elastic
