// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nodal::elastic::show {

std::vector<double> Projection::nearness(const std::vector<Vector>& positions) const {
  if (freedoms_.dimension == 2 || positions.empty()) return {};
  std::vector<double> near;
  for (const Vector& p : positions) near.push_back(p[0] - p[1] + p[2]);
  const auto [low, high] = std::ranges::minmax(near);
  for (double& n : near) n = high > low ? (n - low) / (high - low) : 1.0;
  return near;
}

std::vector<Ring> Projection::rings(const Body& body) const {
  if (!body.box) return body.rings;
  const auto corner = [&](bool x, bool y, bool z) {
    const Extent& box = *body.box;
    return (*this)({(x ? box.high : box.low)[0], (y ? box.high : box.low)[1], (z ? box.high : box.low)[2]});
  };
  return {
      {corner(false, false, true), corner(true, false, true), corner(true, true, true), corner(false, true, true)},
      {corner(false, false, false), corner(true, false, false), corner(true, false, true), corner(false, false, true)},
      {corner(true, false, false), corner(true, true, false), corner(true, true, true), corner(true, false, true)}};
}

namespace {

// The faces that are seen: x high, y low, z high.
constexpr std::array<bool, 3> kSeenEnd = {true, false, true};

// The nodes of a full grid on the edges of a seen face, around it.
std::vector<std::size_t> around_face(const Grid& grid, std::size_t axis) {
  const std::array<std::size_t, 3> counts = {grid.columns, grid.rows, grid.layers};
  const std::size_t p = axis == 0 ? 1 : 0, q = axis == 2 ? 1 : 2;
  std::array<std::size_t, 3> at{};
  at[axis] = kSeenEnd[axis] ? counts[axis] - 1 : 0;
  std::vector<std::size_t> nodes;
  const auto walk = [&](std::size_t along, bool up) {
    for (std::size_t step = 0; step + 1 < counts[along]; ++step) {
      nodes.push_back((at[2] * counts[1] + at[1]) * counts[0] + at[0]);
      up ? ++at[along] : --at[along];
    }
  };
  walk(p, true);
  walk(q, true);
  walk(p, false);
  walk(q, false);
  return nodes;
}

}  // namespace

std::vector<std::vector<std::size_t>> Projection::border(const Net& net) const {
  if (!net.body.box) return net.outlines;
  return {around_face(net.grid, 0), around_face(net.grid, 1), around_face(net.grid, 2)};
}

std::vector<bool> Projection::seen(const Net& net) const {
  if (!net.body.box) return {};
  const auto on_face = [&](std::size_t node, std::size_t axis) {
    const Extent& box = *net.body.box;
    const double face = (kSeenEnd[axis] ? box.high : box.low)[axis];
    return std::abs(net.nodes[node][axis] - face) <= kPlaceRounding * box.size();
  };
  std::vector<bool> seen;
  for (const Spring& s : net.springs) {
    bool on_one = false;
    for (std::size_t axis = 0; axis < 3; ++axis) on_one = on_one || (on_face(s.first, axis) && on_face(s.second, axis));
    seen.push_back(on_one);
  }
  return seen;
}

}  // namespace nodal::elastic::show
