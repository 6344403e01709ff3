// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/projection.h"

#include <algorithm>

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
  return {{corner(false, false, true), corner(true, false, true), corner(true, true, true), corner(false, true, true)},
          {corner(false, false, false), corner(true, false, false), corner(true, false, true), corner(false, false, true)},
          {corner(true, false, false), corner(true, true, false), corner(true, true, true), corner(true, false, true)}};
}

}  // namespace nodal::elastic::show
