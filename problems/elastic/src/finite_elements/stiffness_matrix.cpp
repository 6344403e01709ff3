// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/stiffness_matrix.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "finite_elements/element.h"
#include "geometry/with_dimension.h"

namespace nodal::elastic::finite_elements {

StiffnessMatrix::StiffnessMatrix(const Mesh& mesh, const std::vector<Region>& regions)
    : freedoms_{mesh.dimension, mesh.nodes.size()} {
  for (const std::size_t region : mesh.region)
    if (region >= regions.size()) throw std::invalid_argument("finite_elements: a cell's region isn't there");
  find_neighbours(mesh);
  blocks_.assign(lower_.size() * mesh.dimension * mesh.dimension, 0.0);
  with_dimension(mesh.dimension, [&](auto dimension) { assemble<dimension()>(mesh, regions); });
}

void StiffnessMatrix::find_neighbours(const Mesh& mesh) {
  std::vector<std::vector<std::size_t>> neighbours(mesh.nodes.size());
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (const std::size_t i : mesh.cell(c))
      for (const std::size_t j : mesh.cell(c))
        if (j <= i) neighbours[i].push_back(j);
  begins_ = {0};
  for (std::vector<std::size_t>& of_node : neighbours) {
    std::ranges::sort(of_node);
    lower_.insert(lower_.end(), of_node.begin(), std::unique(of_node.begin(), of_node.end()));
    begins_.push_back(lower_.size());
    std::vector<std::size_t>().swap(of_node);
  }
}

std::size_t StiffnessMatrix::entry(std::size_t node, std::size_t lower) const {
  const auto begin = lower_.begin() + static_cast<std::ptrdiff_t>(begins_[node]);
  const auto end = lower_.begin() + static_cast<std::ptrdiff_t>(begins_[node + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, lower) - lower_.begin());
}

template <std::size_t D>
void StiffnessMatrix::assemble(const Mesh& mesh, const std::vector<Region>& regions) {
  std::vector<Elastic<D>> elastic;
  for (const Region& region : regions) elastic.push_back(elastic_of<D>(region.compliance));
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const CellStiffness<D> stiffness = cell_stiffness<D>(mesh, c, elastic[mesh.region[c]]);
    const double thickness = regions[mesh.region[c]].thickness;
    const auto nodes = mesh.cell(c);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (nodes[j] > nodes[i]) continue;
        double* block = blocks_.data() + entry(nodes[i], nodes[j]) * D * D;
        for (std::size_t a = 0; a < D; ++a)
          for (std::size_t b = 0; b < D; ++b) block[a * D + b] += thickness * stiffness[i * D + a][j * D + b];
      }
  }
}

UpperTriangle StiffnessMatrix::graph() const {
  UpperTriangle graph;
  graph.begins.assign(begins_.begin(), begins_.end());
  graph.rows.assign(lower_.begin(), lower_.end());
  return graph;
}

UpperTriangle StiffnessMatrix::block(std::span<const int> unknown, std::size_t unknowns) const {
  const std::size_t d = freedoms_.dimension;
  UpperTriangle upper;
  upper.begins.reserve(unknowns + 1);
  upper.rows.reserve(lower_.size() * d * d);
  upper.values.reserve(lower_.size() * d * d);
  for (std::size_t node = 0; node < freedoms_.nodes; ++node)
    for (std::size_t a = 0; a < d; ++a) {
      const int column = unknown[freedoms_.at(node, a)];
      if (column == kHeld) continue;
      for (std::size_t e = begins_[node]; e < begins_[node + 1]; ++e)
        for (std::size_t b = 0; b < d; ++b) {
          const int row = unknown[freedoms_.at(lower_[e], b)];
          if (row == kHeld || row > column) continue;
          upper.rows.push_back(row);
          upper.values.push_back(blocks_[(e * d + a) * d + b]);
        }
      upper.begins.push_back(static_cast<int>(upper.rows.size()));
    }
  return upper;
}

template <class Term>
std::vector<double> StiffnessMatrix::product(std::span<const double> u, Term term) const {
  const std::size_t d = freedoms_.dimension;
  std::vector<double> product(freedoms_.size(), 0.0);
  for (std::size_t node = 0; node < freedoms_.nodes; ++node)
    for (std::size_t e = begins_[node]; e < begins_[node + 1]; ++e)
      for (std::size_t a = 0; a < d; ++a)
        for (std::size_t b = 0; b < d; ++b) {
          const std::size_t i = freedoms_.at(node, a), j = freedoms_.at(lower_[e], b);
          const double k = blocks_[(e * d + a) * d + b];
          product[i] += term(k, u[j]);
          if (lower_[e] != node) product[j] += term(k, u[i]);
        }
  return product;
}

std::vector<double> StiffnessMatrix::times(std::span<const double> u) const {
  return product(u, [](double k, double x) { return k * x; });
}

std::vector<double> StiffnessMatrix::magnitude_times(std::span<const double> u) const {
  return product(u, [](double k, double x) { return std::abs(k * x); });
}

}  // namespace nodal::elastic::finite_elements
