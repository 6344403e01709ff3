// SPDX-License-Identifier: GPL-3.0-or-later
#include "springs/connections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/plane/segment.h"

namespace nodal::elastic {

namespace {

// Twice the signed area of a triangle: positive when c lies left of a → b.
double turn(const plane::Point& a, const plane::Point& b, const plane::Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Height over the longest side, relative to it, and which side that is: from corner `side` to the next.
struct Shape {
  double height = 0.0;
  std::size_t side = 0;
};

Shape shape_of(const std::vector<plane::Point>& nodes, const Triangle& triangle) {
  Shape shape;
  double longest = 0.0;
  for (std::size_t s = 0; s < 3; ++s) {
    const double length = plane::distance(nodes[triangle[s]], nodes[triangle[(s + 1) % 3]]);
    if (length > longest) longest = length, shape.side = s;
  }
  shape.height = std::abs(turn(nodes[triangle[0]], nodes[triangle[1]], nodes[triangle[2]])) / (longest * longest);
  return shape;
}

NodePair side_of(const Triangle& triangle, std::size_t side) {
  return std::minmax(triangle[side], triangle[(side + 1) % 3]);
}

bool convex(const plane::Point& a, const plane::Point& c, const plane::Point& b, const plane::Point& d) {
  return turn(a, c, b) > 0.0 && turn(c, b, d) > 0.0 && turn(b, d, a) > 0.0 && turn(d, a, c) > 0.0;
}

// Nodes in square buckets of about two each, to look for neighbours in.
class Buckets {
 public:
  explicit Buckets(const std::vector<plane::Point>& nodes) : nodes_(nodes), box_(plane::bounding_box(nodes)) {
    const double cells = std::max(1.0, static_cast<double>(nodes.size()) / 2.0);
    const double area = std::max(box_.width(), 1e-9 * box_.size()) * std::max(box_.height(), 1e-9 * box_.size());
    side_ = std::max(std::sqrt(area / cells), box_.size() / 4096.0);
    columns_ = count(box_.width());
    rows_ = count(box_.height());
    members_.resize(columns_ * rows_);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto [column, row] = cell_of(nodes[i]);
      members_[row * columns_ + column].push_back(i);
    }
  }

  // The nodes nearest to node i, nearest first, ties by index.
  std::vector<std::size_t> nearest(std::size_t i, std::size_t wanted) const {
    std::vector<std::pair<double, std::size_t>> found;
    const auto [column, row] = cell_of(nodes_[i]);
    for (std::size_t ring = 0; ring < std::max(columns_, rows_) + 1; ++ring) {
      add_ring(i, column, row, ring, found);
      std::ranges::sort(found);
      // What lies outside the rings seen so far is at least this far away.
      const double seen = static_cast<double>(ring) * side_;
      if (found.size() >= wanted && found[wanted - 1].first + tie() <= seen) break;
    }
    sort_ties(found);
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < std::min(wanted, found.size()); ++k) nodes.push_back(found[k].second);
    return nodes;
  }

 private:
  // Distances that differ by less are equal.
  double tie() const { return kPlaceRounding * box_.size(); }

  // Equal distances, which rounding has put into any order, by index.
  void sort_ties(std::vector<std::pair<double, std::size_t>>& found) const {
    for (auto begin = found.begin(); begin != found.end();) {
      auto end = begin + 1;
      while (end != found.end() && end->first - (end - 1)->first <= tie()) ++end;
      std::ranges::sort(begin, end, {}, &std::pair<double, std::size_t>::second);
      begin = end;
    }
  }

  std::size_t count(double length) const { return static_cast<std::size_t>(length / side_) + 1; }
  std::pair<std::size_t, std::size_t> cell_of(const plane::Point& p) const {
    return {std::min(columns_ - 1, static_cast<std::size_t>((p[0] - box_.low[0]) / side_)),
            std::min(rows_ - 1, static_cast<std::size_t>((p[1] - box_.low[1]) / side_))};
  }
  void add_ring(std::size_t i, std::size_t column, std::size_t row, std::size_t ring,
                std::vector<std::pair<double, std::size_t>>& found) const {
    const auto low = [ring](std::size_t at) { return at >= ring ? at - ring : 0; };
    for (std::size_t r = low(row); r < std::min(rows_, row + ring + 1); ++r)
      for (std::size_t c = low(column); c < std::min(columns_, column + ring + 1); ++c) {
        const std::size_t away = std::max(r > row ? r - row : row - r, c > column ? c - column : column - c);
        if (away != ring) continue;
        for (const std::size_t j : members_[r * columns_ + c])
          if (j != i) found.emplace_back(plane::distance(nodes_[i], nodes_[j]), j);
      }
  }

  const std::vector<plane::Point>& nodes_;
  plane::Box box_;
  double side_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::size_t>> members_;
};

}  // namespace

std::vector<TriangleSide> sides_of(const std::vector<Triangle>& triangles) {
  std::map<NodePair, std::vector<std::size_t>> opposite;
  for (const Triangle& t : triangles)
    for (std::size_t s = 0; s < 3; ++s) opposite[side_of(t, s)].push_back(t[(s + 2) % 3]);
  std::vector<TriangleSide> sides;
  for (auto& [ends, corners] : opposite) sides.push_back({ends, std::move(corners)});
  return sides;
}

std::size_t drop_slivers(const std::vector<plane::Point>& nodes, std::vector<Triangle>& triangles,
                         double least_height) {
  std::size_t dropped = 0;
  while (true) {
    std::map<NodePair, std::size_t> uses;
    for (const Triangle& t : triangles)
      for (std::size_t s = 0; s < 3; ++s) ++uses[side_of(t, s)];
    const std::size_t gone = std::erase_if(triangles, [&](const Triangle& t) {
      const Shape shape = shape_of(nodes, t);
      return shape.height < least_height && uses[side_of(t, shape.side)] == 1;
    });
    if (gone == 0) return dropped;
    dropped += gone;
  }
}

std::vector<NodePair> side_pairs(const std::vector<Triangle>& triangles) {
  std::vector<NodePair> pairs;
  for (const TriangleSide& side : sides_of(triangles)) pairs.push_back(side.ends);
  return pairs;
}

std::vector<NodePair> flip_pairs(const std::vector<plane::Point>& nodes, const std::vector<Triangle>& triangles) {
  const std::vector<TriangleSide> sides = sides_of(triangles);
  std::vector<NodePair> present, flips;
  for (const TriangleSide& side : sides) present.push_back(side.ends);  // sorted, since `sides` are
  for (const TriangleSide& side : sides) {
    if (side.opposite.size() != 2) continue;
    const auto [a, b] = side.ends;
    // c to the right of a → b, d to its left.
    std::size_t c = side.opposite[0], d = side.opposite[1];
    if (turn(nodes[a], nodes[b], nodes[c]) > 0.0) std::swap(c, d);
    const NodePair flip = std::minmax(c, d);
    if (convex(nodes[a], nodes[c], nodes[b], nodes[d]) && !std::ranges::binary_search(present, flip))
      flips.push_back(flip);
  }
  std::ranges::sort(flips);
  flips.erase(std::unique(flips.begin(), flips.end()), flips.end());
  return flips;
}

std::vector<NodePair> nearest_pairs(const plane::Outline* outline, const std::vector<plane::Point>& nodes,
                                    std::size_t count) {
  const Buckets buckets(nodes);
  std::vector<NodePair> pairs;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const std::size_t j : buckets.nearest(i, count))
      if (!outline || outline->covers(nodes[i], nodes[j])) pairs.push_back(std::minmax(i, j));
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace nodal::elastic
