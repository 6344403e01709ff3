// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/body.h>

#include <algorithm>
#include <cmath>

#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {

namespace {

// A vertex that turns by the limit itself is no corner: regular polygons do, by rounding a little more or less, which
// must not make corners of some vertices and not of others. Coordinates are rounded to 1e-9 of the body at worst
// (outline_check.h), a side of a thousandth of its size so to 1e-6.
constexpr double kTurnRounding = 1e-6;

}  // namespace

Box bounding_box(const std::vector<Point>& points) {
  if (points.empty()) return {};
  Box box{points[0], points[0]};
  for (const Point& p : points)
    for (std::size_t a = 0; a < 2; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  return box;
}

// Green: ∫_A ∂Q/∂x dA = ∮ Q dy, side by side; the usual cross-product forms.
Moments moments(const std::vector<Ring>& rings, const Point& origin) {
  if (rings.empty()) return {};
  const Box box = bounding_box(rings[0]);
  const Point middle = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
  Moments m;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const double ax = p[0] - middle[0], ay = p[1] - middle[1], bx = q[0] - middle[0], by = q[1] - middle[1];
      const double cross = ax * by - bx * ay;
      m.area += cross / 2.0;
      m.first[0] += cross * (ax + bx) / 6.0;
      m.first[1] += cross * (ay + by) / 6.0;
      m.xx += cross * (ax * ax + ax * bx + bx * bx) / 12.0;
      m.xy += cross * (2.0 * ax * ay + ax * by + bx * ay + 2.0 * bx * by) / 24.0;
      m.yy += cross * (ay * ay + ay * by + by * by) / 12.0;
    }
  }
  // From the middle to the origin asked for.
  const double sx = middle[0] - origin[0], sy = middle[1] - origin[1];
  m.xx += 2.0 * sx * m.first[0] + sx * sx * m.area;
  m.xy += sx * m.first[1] + sy * m.first[0] + sx * sy * m.area;
  m.yy += 2.0 * sy * m.first[1] + sy * sy * m.area;
  m.first[0] += sx * m.area;
  m.first[1] += sy * m.area;
  return m;
}

double outline_tolerance(const Body& body) {
  if (!body.has_outline()) return 0.0;
  constexpr double kOfHalfAStrip = 0.05;
  double perimeter = 0.0;
  for (const Ring& ring : body.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) perimeter += distance(ring[i], ring[(i + 1) % ring.size()]);
  return std::min(body.on_outline * bounding_box(body.rings[0]).size(),
                  kOfHalfAStrip * std::abs(moments(body.rings).area) / perimeter);
}

bool contains(const Body& body, const Point& point) {
  if (!body.has_outline()) return false;
  const double tolerance = outline_tolerance(body);
  bool inside = false;  // by the number of sides that a ray to the right crosses
  for (const Ring& ring : body.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if (distance_to_segment(point, p, q) <= tolerance) return true;
      if ((p[1] > point[1]) != (q[1] > point[1]) && point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
        inside = !inside;
    }
  }
  return inside;
}

std::vector<std::size_t> corner_vertices(const Ring& ring, double turn) {
  std::vector<std::size_t> corners;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &before = ring[(i + n - 1) % n], &at = ring[i], &after = ring[(i + 1) % n];
    const double ax = at[0] - before[0], ay = at[1] - before[1], bx = after[0] - at[0], by = after[1] - at[1];
    if (std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) > turn + kTurnRounding) corners.push_back(i);
  }
  return corners;
}

}  // namespace nodal::elastic::plane
