// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points of the plane, as the elastic problem's geometry holds them.
///
/// Units    metres.

#include <array>
#include <vector>

#include <nodal/elastic/vector.h>

namespace nodal::elastic {

namespace plane {

using Point = std::array<double, 2>;

/// A closed polygon: the last vertex is joined to the first, which isn't repeated.
using Ring = std::vector<Point>;

}  // namespace plane

/// A position of a plane net, whose third component is 0, and back.
[[nodiscard]] inline plane::Point in_plane(const Vector& v) { return {v[0], v[1]}; }
[[nodiscard]] inline Vector lifted(const plane::Point& p) { return {p[0], p[1], 0.0}; }
[[nodiscard]] std::vector<plane::Point> in_plane(const std::vector<Vector>& positions);
[[nodiscard]] std::vector<Vector> lifted(const std::vector<plane::Point>& points);

}  // namespace nodal::elastic
