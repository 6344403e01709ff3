// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/ties.h"
#include "loads/border_pieces.h"
#include "loads/closed_form.h"
#include "loads/load_set_builder.h"
#include "loads/load_spec.h"

namespace nodal::elastic {

namespace {

using Nodes = std::vector<std::size_t>;

struct Held {
  SupportGroup supports;
  std::vector<double> reference;
};

void require_border(const Net& net) {
  for (std::size_t r = 0; r < net.outlines.size(); ++r)
    if (net.outlines[r].size() < 2)
      throw Refusal(fmt::format("{} has {} on it, so the loads can't pull there: an outline needs at least 2 nodes",
                                r == 0 ? "the outline" : fmt::format("hole {}", r),
                                net.outlines[r].empty() ? "no node" : "only 1 node"));
  if (!net.body.has_outline() && !net.body.box) throw Refusal("the basic loads need a body with an outline to pull at");
}

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

// Distances that differ by less are equal.
double tie(const Net& net) { return kPlaceRounding * extent_of(net.body).size(); }

Nodes side_to_hold(const Net& net, std::size_t axis) {
  Nodes nodes = side_nodes(net, axis, End::low);
  if (nodes.size() < 2)
    throw Refusal(
        fmt::format("supports = 'edge' holds the {} edge of the body, and only {} of the nodes lies there: "
                    "the body has no straight edge on that side",
                    axis == 0 ? "left" : "lower", nodes.size()));
  return nodes;
}

// The node of a side nearest to its middle, seen along the axis.
std::size_t anchor_of(const Net& net, const Nodes& side, std::size_t axis) {
  const Extent box = extent_of(net.body);
  return least_by(side, tie(net), [&](std::size_t i) {
    Vector away{};
    for (std::size_t a = 0; a < net.dimension; ++a)
      if (a != axis) away[a] = net.nodes[i][a] - (box.low[a] + 0.5 * box.along(a));
    return norm(away);
  });
}

// A face turns about its axis, too: its node farthest from the anchor is held across the way there, where the reference
// has it, so that this stays exact.
void hold_turning(const Net& net, const Nodes& face, std::size_t anchor, std::size_t p, std::size_t q, Held& held) {
  const std::size_t far =
      least_by(face, tie(net), [&](std::size_t i) { return -distance(net.nodes[i], net.nodes[anchor]); });
  const Vector away = net.nodes[far] - net.nodes[anchor];
  const std::size_t across = std::abs(away[p]) >= std::abs(away[q]) - tie(net) ? q : p;
  held.supports.supports.push_back({far, across, held.reference[net.freedoms().at(far, across)]});
}

Held slide(const LoadSpec& spec, const Net& net, const Elasticity& elasticity) {
  const Nodes side = side_to_hold(net, spec.axis);
  const std::size_t anchor = anchor_of(net, side, spec.axis);
  Vector origin = net.nodes[anchor];
  origin[spec.axis] = extent_of(net.body).low[spec.axis];
  Held held{{}, displacements_on_a_side(net, elasticity, spec.stress, spec.axis, origin)};
  for (const std::size_t node : side) held.supports.supports.push_back({node, spec.axis, 0.0});
  std::vector<std::size_t> others;
  for (std::size_t axis = 0; axis < net.dimension; ++axis)
    if (axis != spec.axis) others.push_back(axis);
  for (const std::size_t other : others) held.supports.supports.push_back({anchor, other, 0.0});
  if (others.size() == 2) hold_turning(net, side, anchor, others[0], others[1], held);
  return held;
}

Held clamp(const LoadSpec& spec, const Net& net, const Elasticity& elasticity) {
  Held held{{}, displacements_on_a_side(net, elasticity, spec.stress, spec.axis, extent_of(net.body).low)};
  for (const std::size_t node : side_to_hold(net, spec.axis))
    for (std::size_t axis = 0; axis < net.dimension; ++axis) held.supports.supports.push_back({node, axis, 0.0});
  return held;
}

// The lowest corner of a box and those along x and y from it.
Nodes corners(const Net& net) {
  Nodes all(net.nodes.size()), found;
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Extent& box = *net.body.box;
  for (const Vector& place :
       {box.low, Vector{box.high[0], box.low[1], box.low[2]}, Vector{box.low[0], box.high[1], box.low[2]}})
    found.push_back(least_by(all, tie(net), [&](std::size_t i) { return distance(net.nodes[i], place); }));
  return found;
}

// The outline's lowest node, leftmost of several; and the one farthest from it in x, lowest of several. Nodes on one
// edge, twice the tolerance apart at most, count as equally low and as equally far.
Nodes lowest_pair(const Net& net) {
  const double edge = std::max(tie(net), 2.0 * border_tolerance(net.body));
  const auto x = [&](std::size_t i) { return net.nodes[i][0]; };
  const auto y = [&](std::size_t i) { return net.nodes[i][1]; };
  const std::size_t pin = least_by(all_least_by(net.outlines[0], edge, y), tie(net), x);
  const auto nearer = [&](std::size_t i) { return -std::abs(x(i) - x(pin)); };
  return {pin, least_by(all_least_by(net.outlines[0], edge, nearer), tie(net), y)};
}

Vector centre_of(const Body& body) {
  const Extent box = extent_of(body);
  Vector centre{};
  for (std::size_t axis = 0; axis < body.dimension(); ++axis) centre[axis] = box.low[axis] + 0.5 * box.along(axis);
  return centre;
}

Held rest(const LoadSpec& spec, const Net& net, const Elasticity& elasticity) {
  const Nodes nodes = net.body.box ? corners(net) : lowest_pair(net);
  Held held{{},
            is_homogeneous(spec.gradient)
                ? displacements_at_rest(net, elasticity, spec.stress, nodes)
                : displacements_at_rest(net, elasticity, {spec.stress, spec.gradient, centre_of(net.body)}, nodes)};
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t axis = k; axis < net.dimension; ++axis) held.supports.supports.push_back({nodes[k], axis, 0.0});
  return held;
}

Held hold(const LoadSpec& spec, const Net& net, const Elasticity& elasticity) {
  switch (spec.hold) {
    case Hold::sliding:
      return slide(spec, net, elasticity);
    case Hold::clamped:
      return clamp(spec, net, elasticity);
    case Hold::resting:
      return rest(spec, net, elasticity);
  }
  return {};
}

std::vector<double> forces(const LoadSpec& spec, const Net& net) {
  const Nodes bearing = spec.hold == Hold::sliding ? side_nodes(net, spec.axis, End::low) : Nodes();
  const bool homogeneous = is_homogeneous(spec.gradient);
  const Vector centre = centre_of(net.body);
  std::vector<double> forces(net.freedoms().size(), 0.0);
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    if (!piece.within(bearing)) add_stress(net, piece, spec.stress, forces);
    if (!homogeneous) add_stress_growth(net, piece, spec.gradient, centre, forces);
  });
  return forces;
}

}  // namespace

LoadSet discretize(const std::vector<LoadSpec>& specs, const Net& net, const Material& material) {
  require_border(net);
  LoadSetBuilder set(net.freedoms());
  for (const LoadSpec& spec : specs) {
    require_closed_form(spec);
    Held held = hold(spec, net, material.elasticity(net.dimension));
    set.add(spec.name, forces(spec, net), std::move(held.reference), std::move(held.supports));
  }
  return std::move(set).finish();
}

}  // namespace nodal::elastic
