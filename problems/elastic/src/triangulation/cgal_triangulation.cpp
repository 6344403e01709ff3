// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CGAL, as does finite_elements/cgal_mesh.cpp, and nothing else. It is compiled with CGAL's -frounding-math,
// which its interval arithmetic needs and which nothing else here should be slowed down by.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/version.h>
#include <fmt/format.h>

#include <nodal/error.h>

#include "triangulation/triangulation.h"

namespace nodal::elastic {

bool triangulation_available() noexcept { return true; }

std::string triangulation_library() { return CGAL_VERSION_STR; }

namespace plane {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

// A face's info: how many outlines lie between it and the outside, −1 while unknown.
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

std::string name_of(const std::vector<Point>& points, std::size_t i) {
  return fmt::format("{} at ({}, {})", i, points[i][0], points[i][1]);
}

void require_finite(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]))
      throw Refusal(fmt::format("the coordinates of node {} are not finite", name_of(points, i)));
}

// CGAL keeps one of several equal points and says nothing.
[[noreturn]] void name_coinciding(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order,
                    [&](std::size_t a, std::size_t b) { return std::pair(points[a], a) < std::pair(points[b], b); });
  const auto first =
      std::ranges::adjacent_find(order, [&](std::size_t a, std::size_t b) { return points[a] == points[b]; });
  throw Refusal(fmt::format("nodes {} and {} coincide", *first, name_of(points, *(first + 1))));
}

template <class Triangulation>
Triangulation triangulate(const std::vector<Point>& points) {
  require_finite(points);
  std::vector<std::pair<Kernel::Point_2, std::size_t>> numbered;
  numbered.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) numbered.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), i);
  Triangulation made;
  made.insert(numbered.begin(), numbered.end());  // along a space-filling curve
  if (made.number_of_vertices() != points.size()) name_coinciding(points);
  return made;
}

template <class Face>
Triangle triangle_of(const Face& face) {
  Triangle t = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// ---- constrained -------------------------------------------------------------------------------------------------

constexpr double kLeastHeight = 1e-9;  // of a triangle, over its longest edge

using Outlines = std::vector<std::vector<std::size_t>>;

void require_outlines(const std::vector<Point>& nodes, const Outlines& outlines) {
  std::vector<char> listed(nodes.size(), 0);
  for (std::size_t r = 0; r < outlines.size(); ++r) {
    if (outlines[r].size() < 3)
      throw Refusal(fmt::format("outline {} has {} nodes; a polygon needs at least 3", r, outlines[r].size()));
    for (const std::size_t i : outlines[r]) {
      if (i >= nodes.size()) throw Refusal(fmt::format("outline {} lists node {}, which isn't there", r, i));
      if (listed[i]) throw Refusal(fmt::format("the outlines meet at node {}", name_of(nodes, i)));
      listed[i] = 1;
    }
  }
}

// Why nodes i and j could not be joined by one edge: another lies between them.
[[noreturn]] void name_passed(const Constrained& made, const std::vector<Point>& nodes, Constrained::Vertex_handle i,
                              Constrained::Vertex_handle j) {
  for (const Constrained::Vertex_handle v : made.finite_vertex_handles())
    if (v != i && v != j && CGAL::are_ordered_along_line(i->point(), v->point(), j->point()))
      throw Refusal(fmt::format("the outline from node {} to node {} passes through node {}, which it doesn't list",
                                name_of(nodes, i->info()), name_of(nodes, j->info()), name_of(nodes, v->info())));
  throw std::logic_error("an outline's edge is missing from the triangulation");
}

void insert_outlines(Constrained& made, const std::vector<Point>& nodes, const Outlines& outlines) {
  std::vector<Constrained::Vertex_handle> handles(nodes.size());
  for (const Constrained::Vertex_handle v : made.finite_vertex_handles()) handles[v->info()] = v;
  for (const std::vector<std::size_t>& ring : outlines) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto i = handles[ring[k]], j = handles[ring[(k + 1) % ring.size()]];
      try {
        made.insert_constraint(i, j);
      } catch (const Constrained::Intersection_of_constraints_exception&) {
        throw Refusal(
            fmt::format("the outline from node {} to node {} crosses another part of the outlines; "
                        "more nodes on the outlines would keep them apart",
                        name_of(nodes, i->info()), name_of(nodes, j->info())));
      }
      if (!made.is_edge(i, j)) name_passed(made, nodes, i, j);
    }
  }
}

// Nodes on one line up to rounding make a triangle all the same: a net's hidden mechanism.
void require_height(const std::vector<Point>& nodes, const Triangle& t) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = nodes[t[k]], &q = nodes[t[(k + 1) % 3]];
    longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1]));
  }
  const Point &a = nodes[t[0]], &b = nodes[t[1]], &c = nodes[t[2]];
  const double twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (!(twice_area >= kLeastHeight * longest * longest))
    throw Refusal(fmt::format("nodes {}, {} and {} make a triangle without height", name_of(nodes, t[0]),
                              name_of(nodes, t[1]), name_of(nodes, t[2])));
}

// Faces are flooded from the outside; a step over an outline goes one deeper.
void count_depth(Constrained& made) {
  for (const Constrained::Face_handle f : made.all_face_handles()) f->info() = -1;
  std::vector<Constrained::Face_handle> layer = {made.infinite_face()}, beyond;
  for (int depth = 0; !layer.empty(); ++depth) {
    while (!layer.empty()) {
      const Constrained::Face_handle f = layer.back();
      layer.pop_back();
      if (f->info() >= 0) continue;
      f->info() = depth;
      for (int k = 0; k < 3; ++k) (f->is_constrained(k) ? beyond : layer).push_back(f->neighbor(k));
    }
    layer.swap(beyond);
  }
}

}  // namespace

Neighbours delaunay_neighbours(const std::vector<Point>& points) {
  const auto made = triangulate<Delaunay>(points);
  std::vector<std::array<std::size_t, 2>> edges;
  edges.reserve(3 * points.size());
  for (const Delaunay::Edge& e : made.finite_edges())
    edges.push_back(
        {e.first->vertex(Delaunay::cw(e.second))->info(), e.first->vertex(Delaunay::ccw(e.second))->info()});
  return {points.size(), edges};
}

std::vector<Triangle> delaunay_triangles(const std::vector<Point>& points) {
  const auto made = triangulate<Delaunay>(points);
  std::vector<Triangle> triangles;
  for (const Delaunay::Face_handle f : made.finite_face_handles()) triangles.push_back(triangle_of(f));
  std::ranges::sort(triangles);
  return triangles;
}

std::vector<Triangle> constrained_triangles(const std::vector<Point>& nodes, const Outlines& outlines) {
  require_outlines(nodes, outlines);
  auto made = triangulate<Constrained>(nodes);
  insert_outlines(made, nodes, outlines);
  if (made.dimension() < 2) throw Refusal("all nodes lie on one line");
  count_depth(made);
  std::vector<Triangle> triangles;
  std::vector<char> used(nodes.size(), 0);
  for (const Constrained::Face_handle f : made.finite_face_handles()) {
    if (f->info() != 1) continue;  // deeper: in a hole
    triangles.push_back(triangle_of(f));
    require_height(nodes, triangles.back());
    for (const std::size_t i : triangles.back()) used[i] = 1;
  }
  if (const auto lost = std::ranges::find(used, 0); lost != used.end())
    throw Refusal(fmt::format(
        "node {} lies outside of the polygon that the outlines' nodes make; more nodes on the outlines would "
        "follow them closer",
        name_of(nodes, static_cast<std::size_t>(lost - used.begin()))));
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace plane

}  // namespace nodal::elastic
