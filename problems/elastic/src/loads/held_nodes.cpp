// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/held_nodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/ties.h"
#include "loads/border_pieces.h"

namespace nodal::elastic {

namespace {

using Nodes = std::vector<std::size_t>;

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

// A face turns about its axis, too: its node farthest from the anchor is held across the way there.
Support turning_support(const Net& net, const Nodes& face, std::size_t anchor, std::size_t p, std::size_t q) {
  const std::size_t far =
      least_by(face, tie(net), [&](std::size_t i) { return -distance(net.nodes[i], net.nodes[anchor]); });
  const Vector away = net.nodes[far] - net.nodes[anchor];
  return {far, std::abs(away[p]) >= std::abs(away[q]) - tie(net) ? q : p};
}

HeldNodes slide(const LoadSpec& spec, const Net& net) {
  HeldNodes held{.side = side_to_hold(net, spec.axis)};
  const std::size_t anchor = anchor_of(net, held.side, spec.axis);
  held.origin = net.nodes[anchor];
  held.origin[spec.axis] = extent_of(net.body).low[spec.axis];
  for (const std::size_t node : held.side) held.supports.push_back({node, spec.axis});
  Nodes others;
  for (std::size_t axis = 0; axis < net.dimension; ++axis)
    if (axis != spec.axis) others.push_back(axis);
  for (const std::size_t other : others) held.supports.push_back({anchor, other});
  if (others.size() == 2) {
    held.supports.push_back(turning_support(net, held.side, anchor, others[0], others[1]));
    held.as_reference = {net.freedoms().at(held.supports.back().node, held.supports.back().axis)};
  }
  return held;
}

HeldNodes clamp(const LoadSpec& spec, const Net& net) {
  HeldNodes held{.side = side_to_hold(net, spec.axis), .origin = extent_of(net.body).low};
  for (const std::size_t node : held.side)
    for (std::size_t axis = 0; axis < net.dimension; ++axis) held.supports.push_back({node, axis});
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

HeldNodes rest(const Net& net) {
  HeldNodes held{.rest = net.body.box ? corners(net) : lowest_pair(net)};
  held.origin = net.nodes[held.rest[0]];
  for (std::size_t k = 0; k < held.rest.size(); ++k)
    for (std::size_t axis = k; axis < net.dimension; ++axis) held.supports.push_back({held.rest[k], axis});
  return held;
}

}  // namespace

HeldNodes held_nodes(const LoadSpec& spec, const Net& net) {
  switch (spec.hold) {
    case Hold::sliding:
      return slide(spec, net);
    case Hold::clamped:
      return clamp(spec, net);
    case Hold::resting:
      return rest(net);
  }
  return {};
}

}  // namespace nodal::elastic
