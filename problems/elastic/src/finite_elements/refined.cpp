// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "finite_elements/mesh.h"

namespace nodal::elastic::finite_elements {

namespace {

using Child = std::vector<std::size_t>;  // vertices, by the parent's nodes

// Those that keep a vertex first; of a tetrahedron they leave an octahedron.
const std::vector<Child>& children_at_vertices(std::size_t dimension) {
  static const std::array<std::vector<Child>, 4> kChildren = {
      {{},
       {{0, 2}, {2, 1}},
       {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}},
       {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}}}};
  return kChildren[dimension];
}

// An octahedron's diagonals, and the four nodes around each in turn.
struct Diagonal {
  std::size_t from, to;
  std::array<std::size_t, 4> around;
};
constexpr std::array<Diagonal, 3> kDiagonals = {{{4, 9, {5, 6, 7, 8}}, {5, 7, {4, 6, 9, 8}}, {6, 8, {4, 5, 9, 7}}}};

// Equal diagonals differ by rounding: then the first is taken.
const Diagonal& shortest_diagonal(const Mesh& mesh, std::span<const std::size_t> nodes) {
  const auto length = [&](const Diagonal& d) { return distance(mesh.nodes[nodes[d.from]], mesh.nodes[nodes[d.to]]); };
  const Diagonal* shortest = kDiagonals.data();
  for (const Diagonal& d : kDiagonals)
    if (length(d) < (1.0 - 1e-9) * length(*shortest)) shortest = &d;
  return *shortest;
}

double six_volumes(const Mesh& mesh, std::span<const std::size_t> nodes, const Child& t) {
  const Vector& o = mesh.nodes[nodes[t[0]]];
  return dot(cross(mesh.nodes[nodes[t[1]]] - o, mesh.nodes[nodes[t[2]]] - o), mesh.nodes[nodes[t[3]]] - o);
}

void append_octahedron(const Mesh& mesh, std::span<const std::size_t> nodes, std::vector<std::size_t>& cells) {
  const Diagonal& d = shortest_diagonal(mesh, nodes);
  for (std::size_t k = 0; k < 4; ++k) {
    Child t = {d.from, d.to, d.around[k], d.around[(k + 1) % 4]};
    if (six_volumes(mesh, nodes, t) < 0.0) std::swap(t[2], t[3]);
    for (const std::size_t node : t) cells.push_back(nodes[node]);
  }
}

void append_children(std::span<const std::size_t> nodes, std::size_t dimension, std::vector<std::size_t>& simplices) {
  for (const Child& child : children_at_vertices(dimension))
    for (const std::size_t node : child) simplices.push_back(nodes[node]);
}

}  // namespace

Mesh refined(const Mesh& mesh) {
  LinearMesh linear;
  linear.dimension = mesh.dimension;
  linear.vertices = mesh.nodes;
  const std::size_t per_cell = children_per_cell(mesh.dimension), per_side = children_per_cell(mesh.dimension - 1);
  const bool leaves_octahedron = children_at_vertices(mesh.dimension).size() < per_cell;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    append_children(mesh.cell(c), mesh.dimension, linear.cells);
    if (leaves_octahedron) append_octahedron(mesh, mesh.cell(c), linear.cells);
    linear.region.insert(linear.region.end(), per_cell, mesh.region[c]);
  }
  for (std::size_t s = 0; s < mesh.side_count(); ++s) {
    append_children(mesh.side(s), mesh.dimension - 1, linear.sides);
    linear.side_label.insert(linear.side_label.end(), per_side, mesh.side_label[s]);
  }
  return quadratic(linear);
}

std::vector<Ancestor> ancestors(const Mesh& mesh, std::size_t refinements) {
  constexpr std::size_t kMiddle = 3;  // of a triangle's children, the one that keeps no vertex
  const std::size_t per_cell = children_per_cell(2);
  std::vector<Ancestor> all;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    all.push_back({{mesh.cell(c)[0], mesh.cell(c)[1], mesh.cell(c)[2]}, c});
  for (std::size_t r = 0; r < refinements; ++r) {
    for (std::size_t c = 0; c < all.size() / per_cell; ++c) {
      const Ancestor* child = &all[per_cell * c];
      all[c] = {{child[0].vertices[0], child[1].vertices[1], child[2].vertices[2]}, child[kMiddle].middle};
    }
    all.resize(all.size() / per_cell);
  }
  return all;
}

}  // namespace nodal::elastic::finite_elements
