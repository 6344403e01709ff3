// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Triangulations of points of the plane, by CGAL's exact predicates: right for every input, however degenerate.
///
/// cgal_triangulation.cpp does the work; a build without CGAL compiles absent_triangulation.cpp instead, where every
/// function but the first throws InputError with what to install. Results depend on the points and their order alone.
///
/// Errors   Refusal, naming the nodes, for what has no triangulation: coordinates that are not finite,
///          nodes that coincide, and what is said below.
/// Cost     n log n; 10,000 points take some 10 ms.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/elastic/point.h>

namespace nodal::elastic {

/// Whether this build can triangulate.
[[nodiscard]] bool triangulation_available() noexcept;
/// The library's version, "5.5.1"; in a build without it what that lacks and how to get it.
[[nodiscard]] std::string triangulation_library();

namespace plane {

/// Per node its neighbours, ascending.
class Neighbours {
 public:
  Neighbours() = default;
  /// From the edges, each once.
  Neighbours(std::size_t nodes, const std::vector<std::array<std::size_t, 2>>& edges);

  [[nodiscard]] std::span<const std::size_t> of(std::size_t node) const {
    return {others_.data() + begin_[node], begin_[node + 1] - begin_[node]};
  }
  [[nodiscard]] std::size_t nodes() const noexcept { return begin_.size() - 1; }

 private:
  std::vector<std::size_t> begin_ = {0}, others_;
};

/// Neighbours in the Delaunay triangulation: a node's Voronoi cell is bounded by its bisectors with these. Points on
/// one line are neighbours in their order along it.
[[nodiscard]] Neighbours delaunay_neighbours(const std::vector<Point>& points);

/// The Delaunay triangles of the points' convex hull, counterclockwise, each beginning with its smallest index, in
/// ascending order; none for points on one line.
[[nodiscard]] std::vector<Triangle> delaunay_triangles(const std::vector<Point>& points);

/// The constrained Delaunay triangles within the polygon that the outlines' nodes make (Net::outlines: [0] around
/// everything, the others around holes), in the order and sense of delaunay_triangles. Every node is in some triangle.
/// Refusal as well for an outline of fewer than 3 nodes, outlines that cross or touch, a node that an
/// outline passes through without listing it, a triangle less than 1e-9 as high as long, and a node outside of the
/// polygon: there the outline needs more nodes.
[[nodiscard]] std::vector<Triangle> constrained_triangles(const std::vector<Point>& nodes,
                                                          const std::vector<std::vector<std::size_t>>& outlines);

}  // namespace plane

}  // namespace nodal::elastic
