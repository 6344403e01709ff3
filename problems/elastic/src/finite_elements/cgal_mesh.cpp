// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CGAL, and is compiled with what that needs, like triangulation/cgal_triangulation.cpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <nodal/elastic/body.h>
#include <nodal/error.h>

#include "finite_elements/plane_graph.h"
#include "finite_elements/plane_mesh.h"
#include "finite_elements/size_field.h"

namespace nodal::elastic::finite_elements {

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Of a place of the graph its number; later the vertex's in the mesh.
struct Number {
  std::size_t value = kNone;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::Exact_predicates_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

// How far a triangle is from a place within it, at least, in longest edges: its centre may be there.
constexpr double kLeastDistance = 0.25;

// CGAL's: the longest edge over what may be (large triangles first), then the smallest angle. Here what may be depends
// on the place.
class Criteria : public virtual CGAL::Delaunay_mesh_criteria_2<Triangulation> {
 public:
  using Base = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  using Quality = Base::Quality;

  Criteria() = default;
  explicit Criteria(const SizeField& size) : size_(&size) {}

  class Is_bad : public Base::Is_bad {
   public:
    Is_bad(double aspect, const SizeField& size) : Base::Is_bad(aspect, 0.0, Kernel()), size_(size) {}
    using Base::Is_bad::operator();

    CGAL::Mesh_2::Face_badness operator()(const Face& face, Quality& quality) const {
      const auto& p = face->vertex(0)->point();
      const auto& q = face->vertex(1)->point();
      const auto& r = face->vertex(2)->point();
      const double longest =
          std::max({CGAL::to_double(CGAL::squared_distance(p, q)), CGAL::to_double(CGAL::squared_distance(q, r)),
                    CGAL::to_double(CGAL::squared_distance(r, p))});
      const double size =
          size_.at((p.x() + q.x() + r.x()) / 3.0, (p.y() + q.y() + r.y()) / 3.0, kLeastDistance * std::sqrt(longest));
      const double excess = longest / (size * size);
      const auto shape = Base::Is_bad::operator()(face, quality);
      quality.second = excess;
      if (excess > 1.0) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return shape;
    }

   private:
    const SizeField& size_;
  };
  Is_bad is_bad_object() const { return Is_bad(bound(), *size_); }

 private:
  const SizeField* size_ = nullptr;
};

double area_of(const Face& face) {
  return CGAL::to_double(CGAL::area(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
}

plane::Point centre_of(const Face& face) {
  plane::Point centre{};
  for (int k = 0; k < 3; ++k) {
    centre[0] += face->vertex(k)->point().x() / 3.0;
    centre[1] += face->vertex(k)->point().y() / 3.0;
  }
  return centre;
}

// The faces that constraints separate from all others, from one of them on.
std::vector<Face> component(const Triangulation& made, const Face& from, CGAL::Unique_hash_map<Face, char>& seen) {
  std::vector<Face> faces = {from};
  seen[from] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Face next = faces[i]->neighbor(k);
      if (faces[i]->is_constrained(k) || made.is_infinite(next) || seen[next]) continue;
      seen[next] = 1;
      faces.push_back(next);
    }
  return faces;
}

// A component is in the body when the centre of its largest face is: one that rounding can't move out.
void mark_body(Triangulation& made, const std::vector<LabelledRing>& rings) {
  CGAL::Unique_hash_map<Face, char> seen(0);
  for (const Face face : made.all_face_handles()) face->set_in_domain(false);
  for (const Face face : made.finite_face_handles()) {
    if (seen[face]) continue;
    const std::vector<Face> faces = component(made, face, seen);
    const auto largest = std::ranges::max_element(faces, {}, area_of);
    const bool inside = within(rings, centre_of(*largest));
    for (const Face& f : faces) f->set_in_domain(inside);
  }
  for (const Face face : made.all_face_handles())
    if (made.is_infinite(face)) face->set_in_domain(false);
}

// Far around the places. Without it a vertex that rounding leaves a little inside of the hull's edge makes a triangle
// without height there, outside of the body, and refining mistakes such for its own.
void insert_frame(Triangulation& made, const std::vector<plane::Point>& places) {
  const plane::Box box = plane::bounding_box(places);
  const double away = box.size();
  for (const double x : {box.low[0] - away, box.high[0] + away})
    for (const double y : {box.low[1] - away, box.high[1] + away}) made.insert({x, y});
}

Triangulation triangulated(const PlaneGraph& graph) {
  Triangulation made;
  insert_frame(made, graph.places);
  std::vector<Vertex> vertices;
  Face near;
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    vertices.push_back(made.insert({graph.places[i][0], graph.places[i][1]}, near));
    vertices.back()->info().value = i;
    near = vertices.back()->face();
  }
  for (const auto* pieces : {&graph.border, &graph.interfaces})
    for (const auto& [from, to] : *pieces) made.insert_constraint(vertices[from], vertices[to]);
  return made;
}

[[noreturn]] void name_crowd(const Triangulation& made, std::size_t limit) {
  Face smallest;
  for (const Face face : made.finite_face_handles())
    if (face->is_in_domain() && (smallest == Face() || area_of(face) < area_of(smallest))) smallest = face;
  const plane::Point at = centre_of(smallest);
  throw TooLarge(
      fmt::format("a finite-element mesh of the body would have more than {} triangles; the smallest are at "
                  "({:.6g}, {:.6g}), where two borders or interfaces come close or meet in a sharp angle",
                  limit, at[0], at[1]));
}

void refine(Triangulation& made, const SizeField& size, std::size_t cell_limit) {
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(made, Criteria(size));
  mesher.init(true);
  while (!mesher.is_refinement_done()) {
    mesher.step_by_step_refine_mesh();
    if (made.number_of_faces() > 2 * cell_limit) name_crowd(made, cell_limit);
  }
}

void append_cells(const Triangulation& made, const PlaneBody& body, LinearMesh& mesh) {
  for (const Face face : made.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    for (int k = 0; k < 3; ++k) {
      std::size_t& number = face->vertex(k)->info().value;
      if (number == kNone) {
        number = mesh.vertices.size();
        mesh.vertices.push_back({face->vertex(k)->point().x(), face->vertex(k)->point().y(), 0.0});
      }
      mesh.cells.push_back(number);
    }
    mesh.region.push_back(body.region ? body.region(lifted(centre_of(face))) : 0);
  }
}

// Of each vertex on the border the next one, with the body to the left.
std::vector<std::size_t> next_on_border(const Triangulation& made, std::size_t vertices) {
  std::vector<std::size_t> next(vertices, kNone);
  for (const Face face : made.finite_face_handles())
    for (int k = 0; k < 3; ++k)
      if (face->is_in_domain() && !face->neighbor(k)->is_in_domain())
        next[face->vertex(Triangulation::ccw(k))->info().value] = face->vertex(Triangulation::cw(k))->info().value;
  return next;
}

// From one end of each of the graph's pieces along the border to the other.
void append_sides(const Triangulation& made, const PlaneGraph& graph, LinearMesh& mesh) {
  const std::vector<std::size_t> next = next_on_border(made, mesh.vertices.size());
  for (std::size_t piece = 0; piece < graph.border.size(); ++piece) {
    const auto& [from, to] = graph.border[piece];
    for (std::size_t at = from; at != to; at = next[at]) {
      if (next[at] == kNone || mesh.side_label.size() > mesh.vertices.size())
        throw Refusal(fmt::format("the outline can't be followed from ({:.6g}, {:.6g}) on: its sides meet or cross",
                                  graph.places[from][0], graph.places[from][1]));
      mesh.sides.insert(mesh.sides.end(), {at, next[at]});
      mesh.side_label.push_back(graph.label[piece]);
    }
  }
}

SizeField size_field(const PlaneBody& body, double spacing) {
  SizeField size(spacing, kGradingReach * size_of(body));
  for (const plane::Point& p : body.graded) size.grade(p, kGrading);
  for (const plane::Point& p : body.crossings) size.grade(p, std::max(kGrading, 1.0 - body.crossing_exponent / 1.5));
  for (const LabelledRing& ring : body.rings) size.grade_corners(ring.points);
  return size;
}

}  // namespace

bool plane_meshes_available() noexcept { return true; }

Mesh plane_mesh(const PlaneBody& body, double spacing) {
  if (!(spacing > 0.0)) throw std::invalid_argument("plane_mesh: the spacing is not positive");
  const PlaneGraph graph = plane_graph(body);
  Triangulation made = triangulated(graph);
  mark_body(made, body.rings);
  refine(made, size_field(body, spacing), body.cell_limit);
  LinearMesh mesh;
  for (const plane::Point& p : graph.places) mesh.vertices.push_back(lifted(p));
  append_cells(made, body, mesh);
  if (mesh.cells.empty()) throw Refusal("the body's outline has no area");
  append_sides(made, graph, mesh);
  return quadratic(without_unused(mesh));
}

}  // namespace nodal::elastic::finite_elements
