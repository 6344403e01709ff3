// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/ring_tree.h"

#include <algorithm>

#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {

namespace {

constexpr std::size_t kSidesPerLeaf = 4;

double squared_distance(const Box& box, const Point& p) {
  const double dx = std::max({box.low[0] - p[0], 0.0, p[0] - box.high[0]});
  const double dy = std::max({box.low[1] - p[1], 0.0, p[1] - box.high[1]});
  return dx * dx + dy * dy;
}

bool apart(const Box& a, const Box& b) {
  return a.high[0] < b.low[0] || a.low[0] > b.high[0] || a.high[1] < b.low[1] || a.low[1] > b.high[1];
}

}  // namespace

RingTree::RingTree(const Ring& ring, std::size_t start) {
  vertices_.reserve(ring.size() + 1);
  for (std::size_t i = 0; i <= ring.size(); ++i) vertices_.push_back(ring[(start + i) % ring.size()]);
  arcs_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < vertices_.size(); ++i)
    arcs_.push_back(arcs_.back() + distance(vertices_[i], vertices_[i + 1]));
  nodes_.reserve(sides());
  build(0, sides());
}

std::size_t RingTree::build(std::size_t begin, std::size_t end) {
  const std::size_t index = nodes_.size();
  Node node{{vertices_[begin], vertices_[begin]}, begin, end, 0, 0};
  for (std::size_t i = begin + 1; i <= end; ++i)
    for (std::size_t a = 0; a < 2; ++a) {
      node.box.low[a] = std::min(node.box.low[a], vertices_[i][a]);
      node.box.high[a] = std::max(node.box.high[a], vertices_[i][a]);
    }
  nodes_.push_back(node);
  if (end - begin > kSidesPerLeaf) {
    const std::size_t middle = begin + (end - begin) / 2;
    const std::size_t left = build(begin, middle), right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return index;
}

std::size_t RingTree::side_at(double arc) const noexcept {
  const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
  return static_cast<std::size_t>(after - arcs_.begin()) - 1;
}

bool RingTree::find_nearest(const Point& point, std::size_t first, std::size_t last, NearestSide& nearest) const {
  return nearest_below(0, point, first, last, nearest);
}

bool RingTree::nearest_below(std::size_t index, const Point& point, std::size_t first, std::size_t last,
                             NearestSide& nearest) const {
  const Node& node = nodes_[index];
  if (node.end <= first || node.begin >= last || squared_distance(node.box, point) >= nearest.squared) return false;
  bool found = false;
  if (node.left == 0) {
    for (std::size_t i = std::max(first, node.begin); i < std::min(last, node.end); ++i) {
      const double share = nearest_share(point, vertices_[i], vertices_[i + 1]);
      const Point at = at_share(vertices_[i], vertices_[i + 1], share);
      const double dx = at[0] - point[0], dy = at[1] - point[1], squared = dx * dx + dy * dy;
      if (!(squared < nearest.squared)) continue;
      nearest = {i, share, squared};
      found = true;
    }
    return found;
  }
  std::size_t near = node.left, far = node.right;
  if (squared_distance(nodes_[far].box, point) < squared_distance(nodes_[near].box, point)) std::swap(near, far);
  found = nearest_below(near, point, first, last, nearest);
  return nearest_below(far, point, first, last, nearest) || found;
}

bool RingTree::surrounds(const Point& point) const { return surrounds_below(0, point); }

bool RingTree::surrounds_below(std::size_t index, const Point& point) const {
  const Node& node = nodes_[index];
  const double x = point[0], y = point[1];
  if (y < node.box.low[1] || y >= node.box.high[1] || x > node.box.high[0]) return false;
  // All of the run lies to the right: how often it crosses the ray's height shows in its ends.
  if (x < node.box.low[0]) return (vertices_[node.begin][1] > y) != (vertices_[node.end][1] > y);
  if (node.left != 0) return surrounds_below(node.left, point) != surrounds_below(node.right, point);
  bool odd = false;
  for (std::size_t i = node.begin; i < node.end; ++i) {
    const Point &p = vertices_[i], &q = vertices_[i + 1];
    if ((p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) odd = !odd;
  }
  return odd;
}

void RingTree::collect(const Box& box, std::vector<std::size_t>& found) const { collect_below(0, box, found); }

void RingTree::collect_below(std::size_t index, const Box& box, std::vector<std::size_t>& found) const {
  const Node& node = nodes_[index];
  if (apart(node.box, box)) return;
  if (node.left == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i) found.push_back(i);
    return;
  }
  collect_below(node.left, box, found);
  collect_below(node.right, box, found);
}

void RingTree::shorten_outside(const Box& box, Ring& shortened) const { shorten_below(0, box, shortened); }

// A run gives all its vertices but the last, which is the first of the next run.
void RingTree::shorten_below(std::size_t index, const Box& box, Ring& shortened) const {
  const Node& node = nodes_[index];
  if (apart(node.box, box)) {
    shortened.push_back(vertices_[node.begin]);
  } else if (node.left == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i) shortened.push_back(vertices_[i]);
  } else {
    shorten_below(node.left, box, shortened);
    shorten_below(node.right, box, shortened);
  }
}

}  // namespace nodal::elastic::plane
