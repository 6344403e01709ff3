// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plane bodies for finite elements.

#include <cmath>
#include <numbers>

#include "finite_elements/plane_mesh.h"

namespace nodal::elastic::finite_elements {

/// Sides 0 to 3 from the lower one on.
inline LabelledRing rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {0, 1, 2, 3}};
}

/// `count` points of an ellipse about the origin from angle to angle, both ends too.
inline plane::Ring arc(double a, double b, double from, double to, std::size_t count) {
  plane::Ring points;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
    points.push_back({a * std::cos(t), b * std::sin(t)});
  }
  return points;
}

/// A regular polygon with vertices on a circle, all sides with one label; its sides' middles lie on the axes.
/// Clockwise as a hole.
inline LabelledRing circle(double radius, std::size_t sides, std::size_t label, bool hole) {
  const double step = 2.0 * std::numbers::pi / static_cast<double>(sides);
  LabelledRing ring;
  for (std::size_t k = 0; k < sides; ++k) {
    const double t = step * (static_cast<double>(k) + 0.5) * (hole ? -1.0 : 1.0);
    ring.points.push_back({radius * std::cos(t), radius * std::sin(t)});
    ring.labels.push_back(label);
  }
  return ring;
}

/// Labels 0, 1, 2 … of the points' own sides.
inline LabelledRing numbered(plane::Ring points) {
  LabelledRing ring{std::move(points), {}};
  for (std::size_t k = 0; k < ring.points.size(); ++k) ring.labels.push_back(k);
  return ring;
}

/// What lies along the way from a to b, both ends too.
inline std::vector<Vector> along(const Vector& a, const Vector& b, std::size_t count) {
  std::vector<Vector> places;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(count - 1);
    places.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
  }
  return places;
}

/// Those of a grid over a box for which `has` holds.
template <class Has>
std::vector<Vector> grid(const Vector& low, const Vector& high, std::size_t count, Has has) {
  std::vector<Vector> places;
  for (const Vector& p : along({low[0], 0.0, 0.0}, {high[0], 0.0, 0.0}, count))
    for (const Vector& q : along({0.0, low[1], 0.0}, {0.0, high[1], 0.0}, count))
      if (const Vector place = {p[0], q[1], low[2]}; has(place)) places.push_back(place);
  return places;
}

}  // namespace nodal::elastic::finite_elements
