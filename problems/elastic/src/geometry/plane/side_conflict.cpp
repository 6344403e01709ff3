// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/side_conflict.h"

#include <algorithm>
#include <tuple>

#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {

namespace {

// A side with its box: along the axis that is swept, and across it.
struct BoxedSide {
  Point p, q;
  RingPlace place;
  std::size_t ring_size;
  double length;
  double low, high, low_across, high_across;
};

bool neighbours(const BoxedSide& a, const BoxedSide& b) {
  if (a.place.ring != b.place.ring) return false;
  const std::size_t n = a.ring_size, i = a.place.index, j = b.place.index;
  return (i + 1) % n == j || (j + 1) % n == i;
}

// Twice the area of the triangle, positive when it turns left.
double area_sign(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

RingPlace end_of(const BoxedSide& side, bool second) {
  return {side.place.ring, second ? (side.place.index + 1) % side.ring_size : side.place.index};
}

std::optional<SideConflict> same_vertex(const BoxedSide& a, const BoxedSide& b, double tolerance) {
  for (const bool end_a : {false, true})
    for (const bool end_b : {false, true}) {
      const RingPlace first = end_of(a, end_a), second = end_of(b, end_b);
      const Point& at = end_a ? a.q : a.p;
      if (first != second && distance(at, end_b ? b.q : b.p) <= tolerance)
        return SideConflict{SideConflict::Kind::same_vertex, first, second, at};
    }
  return {};
}

std::optional<SideConflict> vertex_on_side(const BoxedSide& a, const BoxedSide& b, double tolerance) {
  for (const bool end : {false, true})
    if (const Point& at = end ? a.q : a.p; distance_to_segment(at, b.p, b.q) <= tolerance)
      return SideConflict{SideConflict::Kind::vertex_on_side, end_of(a, end), b.place, at};
  return {};
}

// All of `a` lies to one side of the line through `b`, and keeps the tolerance from it: what most pairs end with.
bool clear_of(const BoxedSide& a, const BoxedSide& b, double tolerance) {
  const double p = area_sign(b.p, b.q, a.p), q = area_sign(b.p, b.q, a.q), least = tolerance * b.length;
  return (p > least && q > least) || (p < -least && q < -least);
}

std::optional<SideConflict> crossing(const BoxedSide& a, const BoxedSide& b) {
  const double p = area_sign(b.p, b.q, a.p), q = area_sign(b.p, b.q, a.q);
  if ((p > 0.0) == (q > 0.0) || (area_sign(a.p, a.q, b.p) > 0.0) == (area_sign(a.p, a.q, b.q) > 0.0)) return {};
  const bool in_order = std::tie(a.place.ring, a.place.index) < std::tie(b.place.ring, b.place.index);
  return SideConflict{SideConflict::Kind::crossing, in_order ? a.place : b.place, in_order ? b.place : a.place,
                      at_share(a.p, a.q, p / (p - q))};
}

std::optional<SideConflict> conflict_of(const BoxedSide& a, const BoxedSide& b, double tolerance) {
  if (neighbours(a, b) || clear_of(a, b, tolerance) || clear_of(b, a, tolerance)) return {};
  if (const auto found = same_vertex(a, b, tolerance)) return found;
  if (const auto found = vertex_on_side(a, b, tolerance)) return found;
  if (const auto found = vertex_on_side(b, a, tolerance)) return found;
  return crossing(a, b);
}

// The axis along which sides overlap less.
std::size_t axis_to_sweep(const std::vector<Ring>& rings) {
  Point extent = {0.0, 0.0};
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        extent[axis] += std::abs(ring[(i + 1) % ring.size()][axis] - ring[i][axis]);
  return extent[0] <= extent[1] ? 0 : 1;
}

std::vector<BoxedSide> sides_in_order(const std::vector<Ring>& rings) {
  const std::size_t axis = axis_to_sweep(rings), across = 1 - axis;
  std::vector<BoxedSide> sides;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const Point &p = rings[r][i], &q = rings[r][(i + 1) % rings[r].size()];
      sides.push_back({p,
                       q,
                       {r, i},
                       rings[r].size(),
                       distance(p, q),
                       std::min(p[axis], q[axis]),
                       std::max(p[axis], q[axis]),
                       std::min(p[across], q[across]),
                       std::max(p[across], q[across])});
    }
  std::ranges::sort(sides, {},
                    [](const BoxedSide& side) { return std::tuple(side.low, side.place.ring, side.place.index); });
  return sides;
}

}  // namespace

std::optional<SideConflict> find_side_conflict(const std::vector<Ring>& rings, double tolerance) {
  const std::vector<BoxedSide> sides = sides_in_order(rings);
  // Those that the sweep hasn't left behind; only what tells most pairs apart, since there may be many.
  struct Active {
    double high, low_across, high_across;
    const BoxedSide* side;
  };
  std::vector<Active> active;
  for (const BoxedSide& side : sides) {
    const double left_behind = side.low - tolerance;
    const double low_across = side.low_across - tolerance, high_across = side.high_across + tolerance;
    std::size_t kept = 0;
    for (const Active& other : active) {
      if (other.high < left_behind) continue;
      active[kept++] = other;
      if (other.low_across > high_across || other.high_across < low_across) continue;
      if (const auto found = conflict_of(*other.side, side, tolerance)) return found;
    }
    active.resize(kept);
    active.push_back({side.high, side.low_across, side.high_across, &side});
  }
  return {};
}

}  // namespace nodal::elastic::plane
