// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How long an edge of a mesh may be at a place.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <nodal/elastic/point.h>

namespace nodal::elastic::finite_elements {

/// spacing · min(1, (d/reach)^power), d the distance from the nearest of `graded`.
struct SizeField {
  double spacing = 1.0, reach = 1.0, power = 1.0;
  std::vector<plane::Point> graded = {};

  [[nodiscard]] double at(double x, double y) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const plane::Point& p : graded) nearest = std::min(nearest, (x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1]));
    const double share = nearest / (reach * reach);
    return share < 1.0 ? spacing * std::pow(share, 0.5 * power) : spacing;
  }
};

}  // namespace nodal::elastic::finite_elements
