// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/mesh.h"
#include "geometry/with_dimension.h"

namespace nodal::elastic::finite_elements {

namespace {

struct Shape {
  std::array<Vector, 4> gradients{};  // of λ
  double measure = 0.0;
};

template <std::size_t D>
Shape shape_of(const Mesh& mesh, std::size_t cell) {
  const auto nodes = mesh.cell(cell);
  const auto edge = [&](std::size_t i) { return mesh.nodes[nodes[i]] - mesh.nodes[nodes[0]]; };
  const Vector a = edge(1), b = edge(2);
  Vector c = {0.0, 0.0, 1.0};
  if constexpr (D > 2) c = edge(3);  // else a prism of height 1 stands on the triangle
  const double determinant = dot(cross(a, b), c);
  Shape shape{{Vector{}, cross(b, c), cross(c, a), cross(a, b)}, determinant / (D > 2 ? 6.0 : 2.0)};
  for (std::size_t i = 1; i <= D; ++i)
    for (std::size_t axis = 0; axis < D; ++axis) {
      shape.gradients[i][axis] /= determinant;
      shape.gradients[0][axis] -= shape.gradients[i][axis];
    }
  return shape;
}

Shape shape_of(const Mesh& mesh, std::size_t cell) {
  return with_dimension(mesh.dimension, [&](auto dimension) { return shape_of<dimension()>(mesh, cell); });
}

}  // namespace

Extent extent_of(const Mesh& mesh) { return elastic::extent_of(mesh.nodes); }

std::array<Vector, 4> barycentric_gradients(const Mesh& mesh, std::size_t cell) {
  return shape_of(mesh, cell).gradients;
}

double measure(const Mesh& mesh, std::size_t cell) { return shape_of(mesh, cell).measure; }

}  // namespace nodal::elastic::finite_elements
