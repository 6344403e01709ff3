// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Distances to the straight sides of a body.

#include <algorithm>
#include <cmath>

#include <nodal/elastic/point.h>

namespace nodal::elastic::plane {

/// Where on the segment p–q the nearest place to a point is: 0 at p, 1 at q.
[[nodiscard]] inline double nearest_share(const Point& point, const Point& p, const Point& q) {
  const double dx = q[0] - p[0], dy = q[1] - p[1], squared = dx * dx + dy * dy;
  if (!(squared > 0.0)) return 0.0;
  return std::clamp(((point[0] - p[0]) * dx + (point[1] - p[1]) * dy) / squared, 0.0, 1.0);
}

[[nodiscard]] inline Point at_share(const Point& p, const Point& q, double share) {
  return {p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])};
}

[[nodiscard]] inline double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

[[nodiscard]] inline double distance_to_segment(const Point& point, const Point& p, const Point& q) {
  return distance(point, at_share(p, q, nearest_share(point, p, q)));
}

}  // namespace nodal::elastic::plane
