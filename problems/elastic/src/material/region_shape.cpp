// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/region_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nodal::elastic {

namespace {

using Segment = std::array<plane::Point, 2>;

plane::Point along(const plane::Point& p, const plane::Point& d, double t) {
  return {p[0] + t * d[0], p[1] + t * d[1]};
}

// What of p + t d, first ≤ t ≤ last, is within the box (Liang and Barsky).
std::optional<Segment> cut(const plane::Point& p, const plane::Point& d, double first, double last, const Extent& box) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (p[axis] < box.low[axis] || p[axis] > box.high[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.low[axis] - p[axis]) / d[axis], b = (box.high[axis] - p[axis]) / d[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last)) return std::nullopt;
  return Segment{along(p, d, first), along(p, d, last)};
}

bool along_border(const Segment& s, const Extent& box, double tolerance) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (const double edge : {box.low[axis], box.high[axis]})
      if (std::abs(s[0][axis] - edge) <= tolerance && std::abs(s[1][axis] - edge) <= tolerance) return true;
  return false;
}

plane::Ring ring_of(const Extent& box) {
  return {{box.low[0], box.low[1]}, {box.high[0], box.low[1]}, {box.high[0], box.high[1]}, {box.low[0], box.high[1]}};
}

double reach(const plane::Point& from, const Extent& box) {
  double farthest = 0.0;
  for (const plane::Point& corner : ring_of(box))
    farthest = std::max(farthest, std::hypot(corner[0] - from[0], corner[1] - from[1]));
  return farthest;
}

// A rectangle on the line, around what of the box is beyond it.
plane::Ring ring_around(const HalfPlane& half, const Extent& box) {
  const double length = std::hypot(half.towards[0], half.towards[1]);
  const plane::Point n = {half.towards[0] / length, half.towards[1] / length}, t = {-n[1], n[0]};
  // The foot of the box's middle, so that a point far away costs no digits.
  const plane::Point middle = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
  const double away = (half.point[0] - middle[0]) * n[0] + (half.point[1] - middle[1]) * n[1];
  const plane::Point foot = along(middle, n, away);
  const double far = 2.0 * reach(middle, box);
  const double depth = std::max(0.0, far - away);
  const plane::Point right = along(foot, t, -far), left = along(foot, t, far);
  return {right, along(right, n, depth), along(left, n, depth), left};
}

// What is far outside of a box decides nothing in it, but costs digits.
Extent near(Extent upright, const Extent& box) {
  const double far = 2.0 * box.size();
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (double* end : {&upright.low[axis], &upright.high[axis]})
      *end = std::clamp(*end, box.low[axis] - far, box.high[axis] + far);
  return upright;
}

// A point of the line: its own, or, where that is far outside, the foot of the box's middle.
plane::Point near(const HalfPlane& half, const Extent& box) {
  const plane::Point middle = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
  const plane::Point from = {half.point[0] - middle[0], half.point[1] - middle[1]};
  if (std::hypot(from[0], from[1]) <= 2.0 * box.size()) return half.point;
  const double length = std::hypot(half.towards[0], half.towards[1]);
  const plane::Point n = {half.towards[0] / length, half.towards[1] / length};
  return along(middle, n, from[0] * n[0] + from[1] * n[1]);
}

void add_sides(const plane::Ring& ring, const Extent& box, std::vector<Segment>& sides) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const plane::Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    if (const auto side = cut(p, {q[0] - p[0], q[1] - p[1]}, 0.0, 1.0, box)) sides.push_back(*side);
  }
}

}  // namespace

std::vector<plane::Ring> rings_around(const RegionShape& shape, const Extent& box) {
  if (const auto* half = std::get_if<HalfPlane>(&shape)) return {ring_around(*half, box)};
  if (const auto* upright = std::get_if<Extent>(&shape)) return {ring_of(near(*upright, box))};
  return std::get<PolygonShape>(shape).rings();
}

std::vector<double> crossings(const plane::Point& p, const plane::Point& q, const std::vector<plane::Ring>& rings) {
  std::vector<double> cuts = {0.0, 1.0};
  const plane::Point d = {q[0] - p[0], q[1] - p[1]};
  const auto beside = [&](const plane::Point& x) { return d[0] * (x[1] - p[1]) - d[1] * (x[0] - p[0]); };
  for (const plane::Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const plane::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double before = beside(a), after = beside(b);
      if ((before < 0.0) == (after < 0.0)) continue;
      const plane::Point at = along(a, {b[0] - a[0], b[1] - a[1]}, before / (before - after));
      const double t = ((at[0] - p[0]) * d[0] + (at[1] - p[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
      if (t > 0.0 && t < 1.0) cuts.push_back(t);
    }
  std::ranges::sort(cuts);
  return cuts;
}

std::vector<Segment> sides_within(const RegionShape& shape, const Extent& box, double tolerance) {
  std::vector<Segment> sides;
  if (const auto* half = std::get_if<HalfPlane>(&shape)) {
    constexpr double kEverywhere = std::numeric_limits<double>::infinity();
    const plane::Point line = {-half->towards[1], half->towards[0]};
    if (const auto side = cut(near(*half, box), line, -kEverywhere, kEverywhere, box)) sides.push_back(*side);
  } else {
    for (const plane::Ring& ring : rings_around(shape, box)) add_sides(ring, box, sides);
  }
  std::erase_if(sides, [&](const Segment& side) { return along_border(side, box, tolerance); });
  return sides;
}

}  // namespace nodal::elastic
