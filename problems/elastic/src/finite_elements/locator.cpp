// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "finite_elements/shape.h"

namespace nodal::elastic::finite_elements {

namespace {

// λ above minus this is inside: what rounding makes of a place on a side.
constexpr double kInside = 1e-12;

constexpr double kFar = std::numeric_limits<double>::infinity();

double smallest(const Barycentric& weights, std::size_t dimension) {
  return *std::min_element(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(dimension + 1));
}

Extent extent_of_cell(const Mesh& mesh, std::size_t cell) {
  const auto nodes = mesh.cell(cell).first(mesh.dimension + 1);
  Extent extent{mesh.nodes[nodes[0]], mesh.nodes[nodes[0]]};
  for (const std::size_t node : nodes)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], mesh.nodes[node][axis]);
      extent.high[axis] = std::max(extent.high[axis], mesh.nodes[node][axis]);
    }
  return extent;
}

}  // namespace

Barycentric barycentric(const Mesh& mesh, std::size_t cell, const Vector& place) {
  const auto gradients = barycentric_gradients(mesh, cell);
  const Vector away = place - mesh.nodes[mesh.cell(cell)[0]];
  Barycentric weights{1.0};
  for (std::size_t i = 1; i <= mesh.dimension; ++i) {
    weights[i] = dot(gradients[i], away);
    weights[0] -= weights[i];
  }
  return weights;
}

double Locator::distance(const Mesh& mesh, const Location& location) {
  const auto gradients = barycentric_gradients(mesh, location.cell);
  double farthest = 0.0;
  for (std::size_t i = 0; i <= mesh.dimension; ++i)
    if (location.weights[i] < -kInside) farthest = std::max(farthest, -location.weights[i] / norm(gradients[i]));
  return farthest;
}

Locator::Locator(const Mesh& mesh) : mesh_(mesh), extent_(finite_elements::extent_of(mesh)) {
  const double cells = static_cast<double>(mesh.cell_count());
  const auto per_axis = static_cast<std::size_t>(std::pow(cells, 1.0 / static_cast<double>(mesh.dimension))) + 1;
  for (std::size_t axis = 0; axis < mesh.dimension; ++axis) counts_[axis] = per_axis;
  std::vector<std::array<std::size_t, 2>> entries;  // bucket, cell
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const Extent around = extent_of_cell(mesh, c);
    const auto low = buckets_at(around.low), high = buckets_at(around.high);
    for_each_bucket(low, high, [&](std::size_t bucket) { entries.push_back({bucket, c}); });
  }
  std::ranges::sort(entries);
  begins_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
  for (const auto& [bucket, cell] : entries) {
    ++begins_[bucket + 1];
    members_.push_back(cell);
  }
  for (std::size_t b = 1; b < begins_.size(); ++b) begins_[b] += begins_[b - 1];
}

std::array<std::size_t, 3> Locator::buckets_at(const Vector& place) const {
  std::array<std::size_t, 3> at{};
  for (std::size_t axis = 0; axis < mesh_.dimension; ++axis) {
    const double share = (place[axis] - extent_.low[axis]) / extent_.along(axis);
    const double count = static_cast<double>(counts_[axis]);
    at[axis] = static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1.0));
  }
  return at;
}

template <class Visit>
void Locator::for_each_bucket(const std::array<std::size_t, 3>& low, const std::array<std::size_t, 3>& high,
                              Visit visit) const {
  for (std::size_t z = low[2]; z <= high[2]; ++z)
    for (std::size_t y = low[1]; y <= high[1]; ++y)
      for (std::size_t x = low[0]; x <= high[0]; ++x) visit((z * counts_[1] + y) * counts_[0] + x);
}

Location Locator::locate(const Vector& place) const {
  const auto middle = buckets_at(place);
  const std::size_t most = *std::ranges::max_element(counts_);
  for (std::size_t reach = 0; reach <= most; ++reach) {
    std::array<std::size_t, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = middle[axis] - std::min(middle[axis], reach);
      high[axis] = std::min(middle[axis] + reach, counts_[axis] - 1);
    }
    const Found found = nearest_among(low, high, place);
    if (found.distance == 0.0 || (reach > 0 && found.distance < kFar)) return found.location;
  }
  return nearest_among({}, {counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}, place).location;
}

Locator::Found Locator::nearest_among(const std::array<std::size_t, 3>& low, const std::array<std::size_t, 3>& high,
                                      const Vector& place) const {
  Found best{{}, kFar};
  for_each_bucket(low, high, [&](std::size_t bucket) {
    for (std::size_t m = begins_[bucket]; m < begins_[bucket + 1] && best.distance > 0.0; ++m) {
      const Location location{members_[m], barycentric(mesh_, members_[m], place)};
      const double out = distance(mesh_, location);
      if (out < best.distance) best = {location, out};
    }
  });
  return best;
}

Location descended(const Mesh& refined_mesh, const Location& location, const Vector& place) {
  const std::size_t children = children_per_cell(refined_mesh.dimension);
  Location best;
  double inside = -kFar;
  for (std::size_t child = children * location.cell; child < children * (location.cell + 1); ++child) {
    const Barycentric weights = barycentric(refined_mesh, child, place);
    const double least = smallest(weights, refined_mesh.dimension);
    if (least > inside) best = {child, weights}, inside = least;
  }
  return best;
}

Vector interpolated(const Mesh& mesh, const Location& location, const std::vector<double>& values) {
  const auto shape = shape_functions(mesh.dimension, location.weights);
  const auto nodes = mesh.cell(location.cell);
  const Freedoms freedoms{mesh.dimension, mesh.nodes.size()};
  Vector sum{};
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t axis = 0; axis < mesh.dimension; ++axis)
      sum[axis] += shape[k] * values[freedoms.at(nodes[k], axis)];
  return sum;
}

}  // namespace nodal::elastic::finite_elements
