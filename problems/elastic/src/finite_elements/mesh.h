// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes of quadratic simplices with straight sides: triangles of 6 nodes in the plane, tetrahedra of 10 in space.
///
/// Order of a cell's nodes: its vertices v_0 … v_D, then the middles of its edges as in `kEdges`: (0,1) (1,2) (2,0) and
/// in space (0,3) (1,3) (2,3). Those of a side are the same one dimension lower: 2 vertices and a middle, or 3 vertices
/// and 3 middles. Cells are counterclockwise, in space of positive volume; a side has its cell's material to its left,
/// in space its vertices run counterclockwise seen from outside.
///
/// Units    metres.
/// Threads  plain values.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <nodal/elastic/vector.h>
#include <nodal/error.h>

namespace nodal::elastic::finite_elements {

/// A mesh, or a factor for one, beyond what is allowed: where another one is fine.
class TooLarge : public Refusal {
 public:
  using Refusal::Refusal;
};

/// A simplex's edges by its vertices; a triangle has the first three, a line the first.
inline constexpr std::array<std::array<std::size_t, 2>, 6> kEdges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// Nodes of a quadratic simplex of so many dimensions: 3, 6, 10.
[[nodiscard]] constexpr std::size_t nodes_of_simplex(std::size_t dimension) {
  return (dimension + 1) * (dimension + 2) / 2;
}

/// λ of a place in a simplex: its vertices' weights, of which there are dimension + 1.
using Barycentric = std::array<double, 4>;

struct Mesh {
  std::size_t dimension = 2;
  std::vector<Vector> nodes;
  std::vector<std::size_t> cells;   ///< [cells][nodes_of_simplex(dimension)]
  std::vector<std::size_t> region;  ///< [cells]

  // The border, side by side.
  std::vector<std::size_t> sides;       ///< [sides][nodes_of_simplex(dimension - 1)]
  std::vector<std::size_t> side_label;  ///< [sides]
  std::vector<std::size_t> side_cell;   ///< [sides] the cell whose side it is

  [[nodiscard]] std::size_t cell_count() const noexcept { return region.size(); }
  [[nodiscard]] std::size_t side_count() const noexcept { return side_label.size(); }
  [[nodiscard]] std::size_t nodes_per_cell() const noexcept { return nodes_of_simplex(dimension); }
  [[nodiscard]] std::size_t nodes_per_side() const noexcept { return nodes_of_simplex(dimension - 1); }
  [[nodiscard]] std::span<const std::size_t> cell(std::size_t c) const {
    return std::span(cells).subspan(c * nodes_per_cell(), nodes_per_cell());
  }
  [[nodiscard]] std::span<const std::size_t> side(std::size_t s) const {
    return std::span(sides).subspan(s * nodes_per_side(), nodes_per_side());
  }
};

/// What a mesh is made of before edges have middles: simplices by their vertices alone.
struct LinearMesh {
  std::size_t dimension = 2;
  std::vector<Vector> vertices;
  std::vector<std::size_t> cells;  ///< [cells][dimension + 1], of positive area or volume
  std::vector<std::size_t> region;
  std::vector<std::size_t> sides;  ///< [sides][dimension] in any order; each is a side of exactly one cell
  std::vector<std::size_t> side_label;
};

/// Without vertices that no cell has; the others keep their order.
[[nodiscard]] LinearMesh without_unused(LinearMesh linear);

/// Gives every edge a middle. The vertices keep their numbers, the middles follow in the order in which cells name
/// them. std::logic_error for a side that is no cell's.
[[nodiscard]] Mesh quadratic(const LinearMesh& linear);

[[nodiscard]] Extent extent_of(const Mesh& mesh);

/// ∇λ of a cell's vertices: what strains and barycentric coordinates are made of.
[[nodiscard]] std::array<Vector, 4> barycentric_gradients(const Mesh& mesh, std::size_t cell);

/// Area or volume of a cell.
[[nodiscard]] double measure(const Mesh& mesh, std::size_t cell);

/// How many cells `refined` makes of one: 4 triangles, 8 tetrahedra.
[[nodiscard]] constexpr std::size_t children_per_cell(std::size_t dimension) { return std::size_t{1} << dimension; }

/// Regular ("red") refinement: every edge is halved. A cell's children are children_per_cell successive cells, first
/// those at its vertices; regions and labels are inherited, and the vertices of the refined mesh are the old nodes,
/// with their numbers. The four tetrahedra within one, around the octahedron that its middles make, share its shortest
/// diagonal, which keeps descendants in shape.
[[nodiscard]] Mesh refined(const Mesh& mesh);

/// A triangle that a mesh in the plane was refined from.
struct Ancestor {
  std::array<std::size_t, 3> vertices{};  ///< nodes of the refined mesh
  std::size_t middle = 0;                 ///< the cell of the refined mesh that has the same centre
};

/// Those of a mesh that was `refined` so many times.
[[nodiscard]] std::vector<Ancestor> ancestors(const Mesh& mesh, std::size_t refinements);

}  // namespace nodal::elastic::finite_elements
