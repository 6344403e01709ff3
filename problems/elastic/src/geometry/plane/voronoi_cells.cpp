// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/voronoi_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {

namespace {

constexpr std::size_t kOutlineLabel = std::numeric_limits<std::size_t>::max();
constexpr double kTooNear = 1e-12;

struct Surroundings {
  Box box;  // about the origin of the body
  double radius = 0.0;
};

Surroundings surroundings_of(const ClippedRegion& region, const Point& node) {
  Surroundings extent{{node, node}, 0.0};
  double squared = 0.0;
  for (const LabelledVertex& v : region.vertices()) {
    squared = std::max(squared, v.at[0] * v.at[0] + v.at[1] * v.at[1]);
    for (std::size_t a = 0; a < 2; ++a) {
      extent.box.low[a] = std::min(extent.box.low[a], node[a] + v.at[a]);
      extent.box.high[a] = std::max(extent.box.high[a], node[a] + v.at[a]);
    }
  }
  extent.radius = std::sqrt(squared);
  return extent;
}

Box grown(const Box& box, double by) {
  return {{box.low[0] - by, box.low[1] - by}, {box.high[0] + by, box.high[1] + by}};
}

double area_of(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()], &o = ring[0];
    twice += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  }
  return 0.5 * twice;
}

}  // namespace

VoronoiCells::VoronoiCells(const Outline& outline, Density density) : outline_(outline), density_(std::move(density)) {}

void VoronoiCells::compute(const std::vector<Point>& nodes) {
  nodes_ = nodes;
  neighbours_ = delaunay_neighbours(nodes_);
  require_apart();
  cells_.resize(nodes_.size());
  distances_.clear();
  pairs_.clear();
  seen_.assign(nodes_.size(), 0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const bool meets_outline = cut(i);
    cells_[i] = sums(i);
    cells_[i].meets_outline = meets_outline;
    note_neighbours(i);
  }
}

// A node's nearest is among its neighbours.
void VoronoiCells::require_apart() const {
  const double least = kTooNear * outline_.box().size();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (const std::size_t j : neighbours_.of(i))
      if (j > i && !(distance(nodes_[i], nodes_[j]) >= least))
        throw Refusal(fmt::format("points {} and {} nearly coincide, at ({}, {})", i, j, nodes_[i][0], nodes_[i][1]));
}

// Makes the region the cell; true where it meets the outline. First without the body, but within its box: that says how
// far the cell can reach at all.
bool VoronoiCells::cut(std::size_t node) {
  const Point& p = nodes_[node];
  const Box box = grown(outline_.box(), 1e-3 * outline_.box().size());
  const std::array<Point, 4> frame = {
      {{box.low[0], box.low[1]}, {box.high[0], box.low[1]}, {box.high[0], box.high[1]}, {box.low[0], box.high[1]}}};
  region_.clear();
  region_.add_ring(frame, p, kOutlineLabel);
  clip_by_neighbours(node);
  const Surroundings extent = surroundings_of(region_, p);
  const double reach = extent.radius * (1.0 + 1e-9);
  if (outline_.distance(p, reach) >= reach) return false;
  cut_body(node, grown(extent.box, outline_.tolerance()));
  return true;
}

void VoronoiCells::cut_body(std::size_t node, const Box& around) {
  region_.clear();
  for (std::size_t r = 0; r < outline_.rings(); ++r) {
    shortened_.clear();
    outline_.ring(r).shorten_outside(around, shortened_);
    region_.add_ring(shortened_, nodes_[node], kOutlineLabel);
  }
  clip_by_neighbours(node);
}

// About the node, the bisector with a neighbour at d is d · x = |d|² / 2.
void VoronoiCells::clip_by_neighbours(std::size_t node) {
  const Point& p = nodes_[node];
  for (const std::size_t j : neighbours_.of(node)) {
    const Point d = {nodes_[j][0] - p[0], nodes_[j][1] - p[1]};
    region_.clip(d, 0.5 * (d[0] * d[0] + d[1] * d[1]), j);
  }
}

// Green's formula; Σ cross (a·a + a·b + b·b) / 12 is the polar moment.
CellSums VoronoiCells::sums(std::size_t node) const {
  CellSums cell;
  WeightedSums& w = cell.weighted;
  for (std::size_t r = 0; r < region_.rings(); ++r) {
    const auto ring = region_.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i].at, &b = ring[i + 1 < ring.size() ? i + 1 : 0].at;
      const double cross = a[0] * b[1] - a[1] * b[0];
      cell.area += cross / 2.0;
      w.first[0] += cross * (a[0] + b[0]) / 6.0;
      w.first[1] += cross * (a[1] + b[1]) / 6.0;
      w.second += cross * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0] + a[1] * a[1] + a[1] * b[1] + b[1] * b[1]) / 12.0;
      if (!density_.uniform()) density_.add_edge(nodes_[node], a, b, w);
    }
  }
  w.mass += cell.area;
  return cell;
}

void VoronoiCells::note_neighbours(std::size_t node) {
  const double least = 1e-6 * even_spacing(outline_.area(), static_cast<double>(nodes_.size()));
  for (std::size_t r = 0; r < region_.rings(); ++r) {
    const auto ring = region_.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = ring[i].label;
      if (j == kOutlineLabel || j < node || seen_[j] == node + 1) continue;
      if (distance(ring[i].at, ring[i + 1 < ring.size() ? i + 1 : 0].at) <= least) continue;
      seen_[j] = node + 1;
      distances_.push_back(distance(nodes_[node], nodes_[j]));
      pairs_.emplace_back(node, j);
    }
  }
}

std::vector<Ring> VoronoiCells::rings(std::size_t node) {
  cut(node);
  const Point& p = nodes_[node];
  const double least = 1e-9 * even_spacing(outline_.area(), static_cast<double>(nodes_.size()));
  std::vector<Ring> rings;
  for (std::size_t r = 0; r < region_.rings(); ++r) {
    Ring ring;
    for (const LabelledVertex& v : region_.ring(r)) {
      const Point at = {p[0] + v.at[0], p[1] + v.at[1]};
      if (ring.empty() || distance(ring.back(), at) > least) ring.push_back(at);
    }
    while (ring.size() > 1 && distance(ring.front(), ring.back()) <= least) ring.pop_back();
    if (ring.size() >= 3 && std::abs(area_of(ring)) > 1e-14 * outline_.area()) rings.push_back(std::move(ring));
  }
  std::stable_partition(rings.begin(), rings.end(), [](const Ring& ring) { return area_of(ring) > 0.0; });
  return rings;
}

}  // namespace nodal::elastic::plane
