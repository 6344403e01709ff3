// SPDX-License-Identifier: GPL-3.0-or-later
#include "body/side_index.h"

#include <algorithm>
#include <cmath>

#include "body/segment.h"

namespace nodal::elastic {

namespace {

// How often a side may stand in the strips, on average, beyond its first time.
constexpr double kEntriesPerSide = 8.0;

template <class Visit>
void for_each_side(const std::vector<Ring>& rings, Visit visit) {
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i)
      visit(RingPlace{r, i}, rings[r][i], rings[r][(i + 1) % rings[r].size()]);
}

}  // namespace

SideIndex::SideIndex(const std::vector<Ring>& rings) : rings_(rings) {
  std::vector<Point> all;
  Point extent = {0.0, 0.0};
  for_each_side(rings, [&](RingPlace, const Point& p, const Point& q) {
    all.push_back(p);
    for (std::size_t a = 0; a < 2; ++a) extent[a] += std::abs(q[a] - p[a]);
  });
  const Box box = bounding_box(all);
  tolerance_ = kOnOutline * bounding_box(rings.at(0)).size();
  axis_ = extent[0] < extent[1] ? 0 : 1;
  // Twice the tolerance: a point at the tolerance itself may not fall through by rounding.
  const double margin = 2.0 * tolerance_, count = static_cast<double>(all.size());
  low_ = box.low[axis_] - margin;
  high_ = box.high[axis_] + margin;
  const double wanted = kEntriesPerSide * count * (high_ - low_) / (extent[axis_] + 2.0 * margin * count);
  strips_ = wanted >= 1.0 ? static_cast<std::size_t>(std::min(wanted, count)) : 1;
  width_ = (high_ - low_) / static_cast<double>(strips_);

  const auto for_its_strips = [&](const Point& p, const Point& q, auto visit) {
    const auto [low, high] = std::minmax(p[axis_], q[axis_]);
    for (std::size_t s = strip_of(low - margin), last = strip_of(high + margin); s <= last; ++s) visit(s);
  };
  starts_.assign(strips_ + 1, 0);
  for_each_side(rings, [&](RingPlace, const Point& p, const Point& q) {
    for_its_strips(p, q, [&](std::size_t s) { ++starts_[s + 1]; });
  });
  for (std::size_t s = 0; s < strips_; ++s) starts_[s + 1] += starts_[s];
  sides_.resize(starts_[strips_]);
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  for_each_side(rings, [&](RingPlace place, const Point& p, const Point& q) {
    for_its_strips(p, q, [&](std::size_t s) { sides_[next[s]++] = place; });
  });
}

// Not decreasing in the coordinate, rounding included: that is what keeps a point with its sides.
std::size_t SideIndex::strip_of(double coordinate) const {
  const double strip = (coordinate - low_) / width_;
  return strip > 0.0 ? std::min(static_cast<std::size_t>(std::min(strip, 1e15)), strips_ - 1) : 0;
}

std::span<const RingPlace> SideIndex::near(const Point& point) const {
  const double coordinate = point[axis_];
  if (!(low_ <= coordinate && coordinate <= high_)) return {};
  const std::size_t strip = strip_of(coordinate);
  return std::span(sides_).subspan(starts_[strip], starts_[strip + 1] - starts_[strip]);
}

bool SideIndex::contains(const Point& point) const {
  const std::size_t along = axis_, across = 1 - axis_;
  bool inside = false;  // by the number of sides that a ray along the strip crosses
  for (const RingPlace place : near(point)) {
    const Ring& ring = rings_[place.ring];
    const Point &p = ring[place.index], &q = ring[(place.index + 1) % ring.size()];
    if (distance_to_segment(point, p, q) <= tolerance_) return true;
    if ((p[along] > point[along]) == (q[along] > point[along])) continue;
    const double share = (point[along] - p[along]) / (q[along] - p[along]);
    if (point[across] < p[across] + share * (q[across] - p[across])) inside = !inside;
  }
  return inside;
}

}  // namespace nodal::elastic
