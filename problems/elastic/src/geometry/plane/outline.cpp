// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {

namespace {

// The angle between the sides at a vertex, on the left of the ring's sense.
double angle_at(const RingTree& ring, std::size_t vertex) {
  const std::size_t before = vertex == 0 ? ring.sides() - 1 : vertex - 1;
  const Point &p = ring.vertex(before), &at = ring.vertex(vertex), &q = ring.vertex(vertex + 1);
  const double ax = at[0] - p[0], ay = at[1] - p[1], bx = q[0] - at[0], by = q[1] - at[1];
  return std::numbers::pi - std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

// Where the segment p–q meets a side: the crossing and the side's ends, as shares of p–q.
void add_cuts(const Point& p, const Point& q, const Point& a, const Point& b, double tolerance,
              std::vector<double>& cuts) {
  const double ux = q[0] - p[0], uy = q[1] - p[1], vx = b[0] - a[0], vy = b[1] - a[1];
  const double cross = ux * vy - uy * vx;
  if (cross != 0.0) {
    const double along = ((a[0] - p[0]) * vy - (a[1] - p[1]) * vx) / cross;
    const double across = ((a[0] - p[0]) * uy - (a[1] - p[1]) * ux) / cross;
    if (along > 0.0 && along < 1.0 && across >= 0.0 && across <= 1.0) cuts.push_back(along);
  }
  for (const Point& end : {a, b})
    if (distance_to_segment(end, p, q) <= tolerance) cuts.push_back(nearest_share(end, p, q));
}

}  // namespace

Outline::Outline(const Body& body) {
  if (!body.has_outline()) throw std::invalid_argument("the body has no outline");
  box_ = bounding_box(body.rings[0]);
  area_ = moments(body.rings).area;
  tolerance_ = outline_tolerance(body);
  for (const Ring& vertices : body.rings) {
    if (vertices.size() < 3) throw std::invalid_argument("a ring of the body has fewer than 3 vertices");
    const std::vector<std::size_t> corners = corner_vertices(vertices, body.corner_turn);
    const std::size_t start = corners.empty() ? 0 : corners[0], index = rings_.size();
    const RingTree& ring = rings_.emplace_back(vertices, start);
    corners_.push_back(corners.size());
    first_chain_.push_back(chains_.size());
    perimeter_ += ring.length();
    if (corners.empty()) chains_.push_back({index, 0.0, ring.length(), true, std::numbers::pi, 0, ring.sides()});
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t first = corners[k] - start;
      const std::size_t last = k + 1 < corners.size() ? corners[k + 1] - start : ring.sides();
      chains_.push_back({index, ring.arc(first), ring.arc(last), false, angle_at(ring, first), first, last});
    }
  }
}

Point Outline::at(std::size_t ring, double arc) const {
  const RingTree& tree = rings_[ring];
  const double length = tree.length();
  if (arc < 0.0 || arc > length) arc -= length * std::floor(arc / length);
  const std::size_t side = tree.side_at(arc);
  const double whole = tree.arc(side + 1) - tree.arc(side);
  const double share = whole > 0.0 ? std::clamp((arc - tree.arc(side)) / whole, 0.0, 1.0) : 0.0;
  // From the end that is nearer, so that both ends are met exactly.
  if (share > 0.5) return at_share(tree.vertex(side + 1), tree.vertex(side), 1.0 - share);
  return at_share(tree.vertex(side), tree.vertex(side + 1), share);
}

std::size_t Outline::chain_of(std::size_t ring, std::size_t side) const {
  const auto begin = chains_.begin() + static_cast<std::ptrdiff_t>(first_chain_[ring]);
  const auto end = begin + static_cast<std::ptrdiff_t>(std::max<std::size_t>(corners_[ring], 1));
  const auto after = std::upper_bound(begin, end, side, [](std::size_t s, const Chain& c) { return s < c.first_side; });
  return static_cast<std::size_t>(after - chains_.begin()) - 1;
}

OutlinePlace Outline::place_at(std::size_t ring, std::size_t chain, const NearestSide& nearest) const {
  const RingTree& tree = rings_[ring];
  const double begin = tree.arc(nearest.side), end = tree.arc(nearest.side + 1);
  return {chain, begin + nearest.share * (end - begin),
          at_share(tree.vertex(nearest.side), tree.vertex(nearest.side + 1), nearest.share),
          std::sqrt(nearest.squared)};
}

OutlinePlace Outline::nearest_on(std::size_t chain, const Point& point) const {
  const Chain& on = chains_[chain];
  NearestSide nearest;
  rings_[on.ring].find_nearest(point, on.first_side, on.last_side, nearest);
  return place_at(on.ring, chain, nearest);
}

OutlinePlace Outline::nearest(const Point& point) const {
  NearestSide nearest;
  std::size_t on = 0;
  for (std::size_t r = 0; r < rings_.size(); ++r)
    if (rings_[r].find_nearest(point, 0, rings_[r].sides(), nearest)) on = r;
  return place_at(on, chain_of(on, nearest.side), nearest);
}

double Outline::distance(const Point& point, double beyond) const {
  NearestSide nearest;
  nearest.squared = beyond * beyond;
  bool found = false;
  for (const RingTree& ring : rings_) found = ring.find_nearest(point, 0, ring.sides(), nearest) || found;
  return found ? std::sqrt(nearest.squared) : beyond;
}

bool Outline::surrounds(const Point& point) const {
  bool inside = false;
  for (const RingTree& ring : rings_) inside = inside != ring.surrounds(point);
  return inside;
}

bool Outline::contains(const Point& point) const {
  return surrounds(point) || distance(point, 2.0 * tolerance()) <= tolerance();
}

// Between two neighbouring cuts the segment is on one side of the outline.
bool Outline::covers(const Point& p, const Point& q) const {
  const double grow = tolerance();
  const Box around = {{std::min(p[0], q[0]) - grow, std::min(p[1], q[1]) - grow},
                      {std::max(p[0], q[0]) + grow, std::max(p[1], q[1]) + grow}};
  std::vector<double> cuts = {0.0, 1.0};
  std::vector<std::size_t> sides;
  for (const RingTree& ring : rings_) {
    sides.clear();
    ring.collect(around, sides);
    for (const std::size_t s : sides) add_cuts(p, q, ring.vertex(s), ring.vertex(s + 1), grow, cuts);
  }
  std::ranges::sort(cuts);
  if (!contains(p) || !contains(q)) return false;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (!contains(at_share(p, q, 0.5 * (cuts[i] + cuts[i + 1])))) return false;
  return true;
}

double Outline::clearance(double spacing) const {
  return std::max(2.0 * tolerance_, 0.01 * std::min(spacing, area_ / perimeter_));
}

double even_spacing(double area, double count) { return std::sqrt(2.0 * area / (std::numbers::sqrt3 * count)); }

}  // namespace nodal::elastic::plane
