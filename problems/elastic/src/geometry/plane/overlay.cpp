// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/overlay.h"

#include <algorithm>
#include <cstddef>

namespace nodal::elastic::plane {

namespace {

// A side that isn't level, from its lower end up.
struct LayerSide {
  Point low, high;
  std::size_t layer;  // 0 the body, else 1 + the index

  [[nodiscard]] double at(double y) const {
    if (y <= low[1]) return low[0];
    if (y >= high[1]) return high[0];
    return low[0] + (y - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
  }
};

// Those that stand beside the box or left of it; others decide nothing within.
void add_sides(const Layer& layer, std::size_t index, const Box& box, std::vector<LayerSide>& sides) {
  for (const Ring& ring : layer)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if (p[1] == q[1] || std::min(p[0], q[0]) > box.high[0]) continue;
      const LayerSide side = p[1] < q[1] ? LayerSide{p, q, index} : LayerSide{q, p, index};
      if (side.high[1] > box.low[1] && side.low[1] < box.high[1]) sides.push_back(side);
    }
}

// Where two sides cross, if they do between their ends.
void add_crossing(const LayerSide& s, const LayerSide& t, std::vector<double>& heights) {
  const double low = std::max(s.low[1], t.low[1]), high = std::min(s.high[1], t.high[1]);
  const double below = s.at(low) - t.at(low), above = s.at(high) - t.at(high);
  if ((below < 0.0 && above > 0.0) || (below > 0.0 && above < 0.0))
    heights.push_back(low + (high - low) * (below / (below - above)));
}

// Ascending, each once; `sides` ascend by their lower ends.
std::vector<double> heights_of(const std::vector<LayerSide>& sides, const Box& box) {
  std::vector<double> heights;
  std::vector<const LayerSide*> active;
  for (const LayerSide& side : sides) {
    std::erase_if(active, [&](const LayerSide* other) { return other->high[1] <= side.low[1]; });
    for (const LayerSide* other : active) add_crossing(side, *other, heights);
    active.push_back(&side);
    heights.push_back(side.low[1]);
    heights.push_back(side.high[1]);
  }
  std::erase_if(heights, [&](double y) { return y < box.low[1] || y > box.high[1]; });
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

// One side within the strip between two heights.
struct Crossing {
  double below, above;
  std::size_t layer;
};

// Adds what is between two heights. `inside` is work space.
void add_strip(std::vector<Crossing>& crossings, double low, double high, const Point& origin,
               std::vector<char>& inside, std::vector<Moments>& parts) {
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return c.below + c.above; });
  std::ranges::fill(inside, 0);
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const Crossing &left = crossings[i], &right = crossings[i + 1];
    inside[left.layer] ^= 1;
    if (!inside[0]) continue;
    std::size_t part = inside.size() - 1;
    while (part > 0 && !inside[part]) --part;
    add(parts[part],
        moments({{{left.below, low}, {right.below, low}, {right.above, high}, {left.above, high}}}, origin), 1.0);
  }
}

}  // namespace

void add(Moments& m, const Moments& part, double factor) {
  m.area += factor * part.area;
  for (std::size_t axis = 0; axis < 2; ++axis) m.first[axis] += factor * part.first[axis];
  m.xx += factor * part.xx;
  m.xy += factor * part.xy;
  m.yy += factor * part.yy;
}

std::vector<Moments> overlay_moments(const Layer& body, const std::vector<Layer>& layers, const Point& origin) {
  std::vector<Moments> parts(1 + layers.size());
  if (body.empty()) return parts;
  std::vector<Point> vertices;
  for (const Ring& ring : body) vertices.insert(vertices.end(), ring.begin(), ring.end());
  const Box box = bounding_box(vertices);
  std::vector<LayerSide> sides;
  add_sides(body, 0, box, sides);
  for (std::size_t k = 0; k < layers.size(); ++k) add_sides(layers[k], k + 1, box, sides);
  std::ranges::sort(sides, {}, [](const LayerSide& side) { return side.low[1]; });
  const std::vector<double> heights = heights_of(sides, box);
  std::vector<char> inside(parts.size());
  std::vector<const LayerSide*> active;
  std::size_t next = 0;
  std::vector<Crossing> crossings;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double low = heights[h], high = heights[h + 1];
    for (; next < sides.size() && sides[next].low[1] <= low; ++next) active.push_back(&sides[next]);
    std::erase_if(active, [&](const LayerSide* side) { return side->high[1] <= low; });
    crossings.clear();
    for (const LayerSide* side : active) crossings.push_back({side->at(low), side->at(high), side->layer});
    add_strip(crossings, low, high, origin, inside, parts);
  }
  return parts;
}

}  // namespace nodal::elastic::plane
