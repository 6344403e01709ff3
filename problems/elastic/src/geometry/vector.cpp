// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <nodal/elastic/point.h>

namespace nodal::elastic {

Extent extent_of(const std::vector<Vector>& positions) {
  if (positions.empty()) return {};
  Extent extent{positions[0], positions[0]};
  for (const Vector& p : positions) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) {
      extent.low[axis] = std::min(extent.low[axis], p[axis]);
      extent.high[axis] = std::max(extent.high[axis], p[axis]);
    }
  }
  return extent;
}

std::vector<plane::Point> in_plane(const std::vector<Vector>& positions) {
  std::vector<plane::Point> points;
  points.reserve(positions.size());
  for (const Vector& p : positions) points.push_back(in_plane(p));
  return points;
}

std::vector<Vector> lifted(const std::vector<plane::Point>& points) {
  std::vector<Vector> positions;
  positions.reserve(points.size());
  for (const plane::Point& p : points) positions.push_back(lifted(p));
  return positions;
}

}  // namespace nodal::elastic
