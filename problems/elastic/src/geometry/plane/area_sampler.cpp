// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/area_sampler.h"

#include <algorithm>
#include <cmath>

namespace nodal::elastic::plane {

namespace {

struct SlantedSide {
  Point low, high;  // by height

  [[nodiscard]] double x_at(double y) const {
    const double share = (y - low[1]) / (high[1] - low[1]);
    return low[0] + share * (high[0] - low[0]);
  }
};

std::vector<SlantedSide> slanted_sides(const Outline& outline) {
  std::vector<SlantedSide> sides;
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const RingTree& ring = outline.ring(r);
    for (std::size_t i = 0; i < ring.sides(); ++i) {
      const Point &p = ring.vertex(i), &q = ring.vertex(i + 1);
      if (p[1] != q[1]) sides.push_back(p[1] < q[1] ? SlantedSide{p, q} : SlantedSide{q, p});
    }
  }
  std::ranges::sort(sides, {}, [](const SlantedSide& s) { return s.low[1]; });
  return sides;
}

std::vector<double> heights_of(const std::vector<SlantedSide>& sides) {
  std::vector<double> heights;
  for (const SlantedSide& s : sides) heights.insert(heights.end(), {s.low[1], s.high[1]});
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace

AreaSampler::AreaSampler(const Outline& outline) {
  const std::vector<SlantedSide> sides = slanted_sides(outline);
  const std::vector<double> heights = heights_of(sides);
  std::vector<const SlantedSide*> across;  // the sides between two heights
  std::size_t next = 0;
  double area = 0.0;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    const double low = heights[k], high = heights[k + 1], middle = 0.5 * (low + high);
    std::erase_if(across, [&](const SlantedSide* s) { return s->high[1] <= low; });
    for (; next < sides.size() && sides[next].low[1] <= low; ++next) across.push_back(&sides[next]);
    // From left to right they enter and leave the body in turn.
    std::ranges::sort(across, {}, [middle](const SlantedSide* s) { return s->x_at(middle); });
    for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
      const Trapezoid t = {
          low, high, across[i]->x_at(low), across[i]->x_at(high), across[i + 1]->x_at(low), across[i + 1]->x_at(high)};
      area += 0.5 * (high - low) * std::max(0.0, t.right_low - t.left_low + t.right_high - t.left_high);
      trapezoids_.push_back(t);
      areas_up_to_.push_back(area);
    }
  }
}

// The height by inverting the area below it: with widths a below and b above, share s solves a s + (b − a) s²/2 =
// r (a + b)/2.
Point AreaSampler::draw(RandomStream& random) const {
  const double pick = random.uniform() * areas_up_to_.back();
  const auto found = std::ranges::upper_bound(areas_up_to_, pick);
  const auto index = std::min(static_cast<std::size_t>(found - areas_up_to_.begin()), trapezoids_.size() - 1);
  const Trapezoid& t = trapezoids_[index];
  const double a = std::max(0.0, t.right_low - t.left_low), b = std::max(0.0, t.right_high - t.left_high);
  const double r = random.uniform(), across = random.uniform();
  const double root = a + std::sqrt(a * a + r * (b * b - a * a));
  const double share = root > 0.0 ? r * (a + b) / root : r;
  const double left = t.left_low + share * (t.left_high - t.left_low);
  const double right = t.right_low + share * (t.right_high - t.right_low);
  return {left + across * (right - left), t.low + share * (t.high - t.low)};
}

}  // namespace nodal::elastic::plane
