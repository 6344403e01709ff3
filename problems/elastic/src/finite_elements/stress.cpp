// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/stress.h"

#include <map>

#include "finite_elements/element.h"
#include "geometry/with_dimension.h"

namespace nodal::elastic::finite_elements {

namespace {

// λ of a cell's node.
Barycentric place_of_node(std::size_t dimension, std::size_t k) {
  Barycentric at{};
  if (k <= dimension) {
    at[k] = 1.0;
  } else {
    for (const std::size_t vertex : kEdges[k - dimension - 1]) at[vertex] = 0.5;
  }
  return at;
}

void add(const Tensor& stress, double weight, Tensor& sum) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) sum[a][b] += weight * stress[a][b];
}

// Which value a cell's node has: one per node and region.
std::vector<std::size_t> number_values(const Mesh& mesh) {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  struct First {
    std::size_t region = kNone, value = 0;
  };
  std::vector<First> first(mesh.nodes.size());                                 // most nodes are of one region
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> on_an_interface;  // in further ones
  std::vector<std::size_t> index;
  index.reserve(mesh.cells.size());
  std::size_t count = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (const std::size_t node : mesh.cell(c)) {
      if (first[node].region == kNone) first[node] = {mesh.region[c], count++};
      if (first[node].region == mesh.region[c]) {
        index.push_back(first[node].value);
        continue;
      }
      const auto [at, added] = on_an_interface.emplace(std::pair(mesh.region[c], node), count);
      if (added) ++count;
      index.push_back(at->second);
    }
  return index;
}

template <std::size_t D>
NodalStress averaged(const Mesh& mesh, const std::vector<Region>& regions, const std::vector<double>& displacement) {
  std::vector<Elastic<D>> elastic;
  for (const Region& region : regions) elastic.push_back(elastic_of<D>(region.compliance));
  NodalStress stress{number_values(mesh), {}};
  std::vector<double> weights;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const double size = measure(mesh, c);
    for (std::size_t k = 0; k < mesh.nodes_per_cell(); ++k) {
      const std::size_t value = stress.index[c * mesh.nodes_per_cell() + k];
      if (value >= weights.size()) weights.resize(value + 1, 0.0), stress.values.resize(value + 1);
      add(cell_stress<D>(mesh, c, place_of_node(D, k), elastic[mesh.region[c]], displacement), size,
          stress.values[value]);
      weights[value] += size;
    }
  }
  for (std::size_t v = 0; v < weights.size(); ++v)
    for (Vector& row : stress.values[v])
      for (double& entry : row) entry /= weights[v];
  return stress;
}

}  // namespace

NodalStress nodal_stress(const Mesh& mesh, const std::vector<Region>& regions,
                         const std::vector<double>& displacement) {
  return with_dimension(mesh.dimension,
                        [&](auto dimension) { return averaged<dimension()>(mesh, regions, displacement); });
}

Tensor stress_at(const Mesh& mesh, const NodalStress& stress, const Location& location) {
  const auto shape = shape_functions(mesh.dimension, location.weights);
  Tensor sum{};
  for (std::size_t k = 0; k < mesh.nodes_per_cell(); ++k)
    add(stress.values[stress.index[location.cell * mesh.nodes_per_cell() + k]], shape[k], sum);
  return sum;
}

}  // namespace nodal::elastic::finite_elements
