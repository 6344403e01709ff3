// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/forces.h"

#include <algorithm>
#include <stdexcept>

#include "finite_elements/shape.h"
#include "geometry/with_dimension.h"

namespace nodal::elastic::finite_elements {

namespace {

// A side's outward normal, as long as the side's length or area.
template <std::size_t D>
Vector area_vector(const Mesh& mesh, std::size_t side) {
  const auto nodes = mesh.side(side);
  const Vector along = mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]];
  if constexpr (D > 2) {
    const Vector twice = cross(along, mesh.nodes[nodes[2]] - mesh.nodes[nodes[0]]);
    return {0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2]};
  } else {
    return {along[1], -along[0], 0.0};
  }
}

Vector area_vector(const Mesh& mesh, std::size_t side) {
  return with_dimension(mesh.dimension, [&](auto dimension) { return area_vector<dimension()>(mesh, side); });
}

// The traction at a place times the side's area.
Vector pulled(const Traction& traction, const Vector& place, const Vector& area) {
  if (const auto* stress = std::get_if<StressField>(&traction.pull)) return stress->at(place) * area;
  if (const auto* stress = std::get_if<StressAt>(&traction.pull)) return (*stress)(place)*area;
  const Vector& constant = std::get<Vector>(traction.pull);
  const double size = norm(area);
  return {size * constant[0], size * constant[1], size * constant[2]};
}

Vector place_on(const Mesh& mesh, std::span<const std::size_t> nodes, const Barycentric& at) {
  Vector place{};
  for (std::size_t k = 0; k < mesh.dimension; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += at[k] * mesh.nodes[nodes[k]][axis];
  return place;
}

class Sum {
 public:
  explicit Sum(const Mesh& mesh) : freedoms_{mesh.dimension, mesh.nodes.size()}, forces_(freedoms_.size(), 0.0) {}

  void add(std::span<const std::size_t> nodes, std::size_t dimension, const Barycentric& at, const Vector& force,
           double factor) {
    const auto shape = shape_functions(dimension, at);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t axis = 0; axis < freedoms_.dimension; ++axis)
        forces_[freedoms_.at(nodes[k], axis)] += factor * shape[k] * force[axis];
  }
  std::vector<double> take() { return std::move(forces_); }

 private:
  Freedoms freedoms_;
  std::vector<double> forces_;
};

void add_traction(const Mesh& mesh, const std::vector<Region>& regions, const Traction& traction, Sum& sum) {
  bool found = false;
  for (std::size_t s = 0; s < mesh.side_count(); ++s) {
    if (mesh.side_label[s] != traction.label) continue;
    found = true;
    const Vector area = area_vector(mesh, s);
    const double thickness = traction.thickness.value_or(regions.at(mesh.region[mesh.side_cell[s]]).thickness);
    for (const QuadraturePoint& q : side_quadrature(mesh.dimension - 1))
      sum.add(mesh.side(s), mesh.dimension - 1, q.at, pulled(traction, place_on(mesh, mesh.side(s), q.at), area),
              thickness * q.weight);
  }
  if (!found) throw std::invalid_argument("finite_elements: a traction's label isn't on the mesh");
}

}  // namespace

std::vector<double> nodal_forces(const Mesh& mesh, const std::vector<Region>& regions, const Load& load) {
  Sum sum(mesh);
  for (const Traction& traction : load.tractions) add_traction(mesh, regions, traction, sum);
  if (load.body_force.empty()) return sum.take();
  if (load.body_force.size() != regions.size())
    throw std::invalid_argument("finite_elements: a body force has an entry per region");
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const std::size_t region = mesh.region[c];
    if (load.body_force[region] == Vector{}) continue;
    for (const QuadraturePoint& q : cell_quadrature(mesh.dimension))
      sum.add(mesh.cell(c), mesh.dimension, q.at, load.body_force[region],
              regions[region].thickness * measure(mesh, c) * q.weight);
  }
  return sum.take();
}

}  // namespace nodal::elastic::finite_elements
