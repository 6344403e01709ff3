// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/placed_load.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/error.h>

#include "loads/border_pieces.h"
#include "loads/held_nodes.h"

namespace nodal::elastic {

namespace {

void require_border(const Net& net) {
  for (std::size_t r = 0; r < net.outlines.size(); ++r)
    if (net.outlines[r].size() < 2)
      throw Refusal(fmt::format("{} has {} on it, so the loads can't pull there: an outline needs at least 2 nodes",
                                r == 0 ? "the outline" : fmt::format("hole {}", r),
                                net.outlines[r].empty() ? "no node" : "only 1 node"));
  if (!net.body.has_outline() && !net.body.box) throw Refusal("the basic loads need a body with an outline to pull at");
}

// The pieces that a load pulls at and, by its side, holds.
BodyLoad on_the_body(const LoadSpec& spec, const Net& net, const HeldNodes& held) {
  BorderPull pull{{}, {spec.stress, spec.gradient, centre_of(net.body)}};
  std::vector<std::size_t> beside;
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    const bool bears = !held.side.empty() && piece.within(held.side);
    if (bears) beside.push_back(index);
    if (!bears || spec.hold != Hold::sliding) pull.pieces.push_back(index);
    ++index;
  });
  BodyLoad load{{std::move(pull)}, {}, {}};
  for (std::size_t axis = 0; axis < net.dimension; ++axis)
    if (spec.hold == Hold::clamped || (spec.hold == Hold::sliding && axis == spec.axis))
      load.holds.push_back({beside, axis});
  for (const Support& support : held.supports)
    if (held.side.empty() || (spec.hold == Hold::sliding && support.axis != spec.axis)) load.points.push_back(support);
  return load;
}

std::vector<double> forces_of(const BodyLoad& load, const Net& net) {
  const BorderPull& pull = load.pulls.front();
  const bool homogeneous = is_homogeneous(pull.stress.gradient);
  std::vector<double> forces(net.freedoms().size(), 0.0);
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    if (!std::ranges::binary_search(pull.pieces, index++)) return;
    add_stress(net, piece, pull.stress.at_centre, forces);
    if (!homogeneous) add_stress_growth(net, piece, pull.stress.gradient, pull.stress.centre, forces);
  });
  return forces;
}

}  // namespace

Vector centre_of(const Body& body) {
  const Extent box = extent_of(body);
  Vector centre{};
  for (std::size_t axis = 0; axis < body.dimension(); ++axis) centre[axis] = box.low[axis] + 0.5 * box.along(axis);
  return centre;
}

PlacedLoad place(const LoadSpec& spec, const Net& net) {
  require_border(net);
  HeldNodes held = held_nodes(spec, net);
  BodyLoad body = on_the_body(spec, net, held);
  return {spec.name,       forces_of(body, net), {std::move(held.supports)}, std::move(held.as_reference),
          std::move(body), spec.beside_set};
}

LoadCase load_case(PlacedLoad&& load, std::vector<double> reference, std::vector<double> uncertainty) {
  return {std::move(load.name), 0, std::move(load.forces), std::move(reference), std::move(uncertainty),
          load.beside_set};
}

void hold_as_reference(PlacedLoad& load, const std::vector<double>& reference, const Freedoms& freedoms) {
  for (Support& support : load.group.supports) {
    const std::size_t freedom = freedoms.at(support.node, support.axis);
    if (std::ranges::binary_search(load.held_as_reference, freedom)) support.value = reference[freedom];
  }
}

}  // namespace nodal::elastic
