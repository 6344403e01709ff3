// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/element.h"

#include <Eigen/Dense>

#include <nodal/error.h>

namespace nodal::elastic::finite_elements {

namespace {

template <std::size_t D>
using Strains = std::array<double, kStrains<D>>;

// Rows of B: the strain of a unit displacement along an axis, of a shape function with this gradient.
template <std::size_t D>
Strains<D> strain_of(const std::array<double, D>& gradient, std::size_t axis) {
  constexpr auto axes = strain_axes<D>();
  Strains<D> strain{};
  for (std::size_t s = 0; s < kStrains<D>; ++s) {
    if (axes[s][0] == axis)
      strain[s] = gradient[axes[s][1]];
    else if (axes[s][1] == axis)
      strain[s] = gradient[axes[s][0]];
  }
  return strain;
}

template <std::size_t D>
Strains<D> times(const Elastic<D>& elastic, const Strains<D>& strain) {
  Strains<D> stress{};
  for (std::size_t s = 0; s < kStrains<D>; ++s)
    for (std::size_t t = 0; t < kStrains<D>; ++t) stress[s] += elastic[s][t] * strain[t];
  return stress;
}

// Where Compliance has the strains of the plane and of space.
template <std::size_t D>
constexpr std::array<std::size_t, kStrains<D>> compliance_rows() {
  if constexpr (D == std::size_t{2})
    return {0, 1, 5};
  else
    return {0, 1, 2, 3, 4, 5};
}

}  // namespace

template <std::size_t D>
Elastic<D> elastic_of(const Compliance& compliance) {
  constexpr int n = static_cast<int>(kStrains<D>);
  constexpr auto rows = compliance_rows<D>();
  Eigen::Matrix<double, n, n> s;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      s(i, j) = compliance[rows[static_cast<std::size_t>(i)]][rows[static_cast<std::size_t>(j)]];
  const Eigen::LLT<Eigen::Matrix<double, n, n>> factor(s);
  if (!(s.array().isFinite().all()) || factor.info() != Eigen::Success)
    throw Refusal("a region's material has a compliance that is not positive definite");
  const Eigen::Matrix<double, n, n> inverse = factor.solve(Eigen::Matrix<double, n, n>::Identity());
  Elastic<D> elastic{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      elastic[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = 0.5 * (inverse(i, j) + inverse(j, i));
  return elastic;
}

template <std::size_t D>
Gradients<D> shape_gradients(const std::array<Vector, 4>& of_vertices, const Barycentric& at) {
  Gradients<D> gradients{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::size_t i = 0; i <= D; ++i) gradients[i][axis] = (4.0 * at[i] - 1.0) * of_vertices[i][axis];
    for (std::size_t e = 0; D + 1 + e < nodes_of_simplex(D); ++e) {
      const auto [i, j] = kEdges[e];
      gradients[D + 1 + e][axis] = 4.0 * (at[i] * of_vertices[j][axis] + at[j] * of_vertices[i][axis]);
    }
  }
  return gradients;
}

template <std::size_t D>
CellStiffness<D> cell_stiffness(const Mesh& mesh, std::size_t cell, const Elastic<D>& elastic) {
  const auto of_vertices = barycentric_gradients(mesh, cell);
  const double size = measure(mesh, cell);
  CellStiffness<D> stiffness{};
  for (const QuadraturePoint& q : cell_quadrature(D)) {
    const Gradients<D> gradients = shape_gradients<D>(of_vertices, q.at);
    std::array<Strains<D>, kCellFreedoms<D>> strain;
    for (std::size_t f = 0; f < kCellFreedoms<D>; ++f) strain[f] = strain_of<D>(gradients[f / D], f % D);
    for (std::size_t f = 0; f < kCellFreedoms<D>; ++f) {
      const Strains<D> stress = times<D>(elastic, strain[f]);
      for (std::size_t g = 0; g <= f; ++g) {
        double sum = 0.0;
        for (std::size_t s = 0; s < kStrains<D>; ++s) sum += stress[s] * strain[g][s];
        stiffness[f][g] += q.weight * size * sum;
      }
    }
  }
  for (std::size_t f = 0; f < kCellFreedoms<D>; ++f)
    for (std::size_t g = 0; g < f; ++g) stiffness[g][f] = stiffness[f][g];
  return stiffness;
}

template <std::size_t D>
Tensor cell_stress(const Mesh& mesh, std::size_t cell, const Barycentric& at, const Elastic<D>& elastic,
                   const std::vector<double>& displacement) {
  const Gradients<D> gradients = shape_gradients<D>(barycentric_gradients(mesh, cell), at);
  const auto nodes = mesh.cell(cell);
  Strains<D> strain{};
  for (std::size_t f = 0; f < kCellFreedoms<D>; ++f) {
    const Strains<D> unit = strain_of<D>(gradients[f / D], f % D);
    const double u = displacement[Freedoms{D, mesh.nodes.size()}.at(nodes[f / D], f % D)];
    for (std::size_t s = 0; s < kStrains<D>; ++s) strain[s] += unit[s] * u;
  }
  const Strains<D> stress = times<D>(elastic, strain);
  constexpr auto axes = strain_axes<D>();
  Tensor tensor{};
  for (std::size_t s = 0; s < kStrains<D>; ++s)
    tensor[axes[s][0]][axes[s][1]] = tensor[axes[s][1]][axes[s][0]] = stress[s];
  return tensor;
}

template Elastic<2> elastic_of<2>(const Compliance&);
template Elastic<3> elastic_of<3>(const Compliance&);
template Gradients<2> shape_gradients<2>(const std::array<Vector, 4>&, const Barycentric&);
template Gradients<3> shape_gradients<3>(const std::array<Vector, 4>&, const Barycentric&);
template CellStiffness<2> cell_stiffness<2>(const Mesh&, std::size_t, const Elastic<2>&);
template CellStiffness<3> cell_stiffness<3>(const Mesh&, std::size_t, const Elastic<3>&);
template Tensor cell_stress<2>(const Mesh&, std::size_t, const Barycentric&, const Elastic<2>&,
                               const std::vector<double>&);
template Tensor cell_stress<3>(const Mesh&, std::size_t, const Barycentric&, const Elastic<3>&,
                               const std::vector<double>&);

}  // namespace nodal::elastic::finite_elements
