// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/border_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nodal::elastic {

bool BorderPiece::within(const std::vector<std::size_t>& ascending) const {
  return std::ranges::all_of(nodes, [&](std::size_t node) { return std::ranges::binary_search(ascending, node); });
}

void for_each_border_piece(const Net& net, const std::function<void(const BorderPiece&)>& visit) {
  for (std::size_t r = 0; r < net.outlines.size(); ++r) {
    const std::vector<std::size_t>& nodes = net.outlines[r];
    if (nodes.size() < 2) continue;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::array<std::size_t, 2> ends = {nodes[i], nodes[(i + 1) % nodes.size()]};
      const Vector along = net.nodes[ends[1]] - net.nodes[ends[0]];
      visit({ends, {along[1], -along[0], 0.0}, 0.5 * net.body.thickness, r});
    }
  }
  for (const Facet& facet : net.border) visit({facet.nodes, facet.area, 1.0 / static_cast<double>(facet.nodes.size())});
}

void add_stress(const Net& net, const BorderPiece& piece, const Tensor& stress, std::span<double> forces) {
  const Vector force = stress * piece.area;
  for (const std::size_t node : piece.nodes)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(node, axis)] += piece.share * force[axis];
}

namespace {

// ∫ of the shape functions of two nodes of a piece over it, as a share of its measure: `apart` is how many steps lie
// between them around the piece.
double shared(std::size_t nodes, std::size_t apart) {
  if (nodes == 4) return (apart == 0 ? 4.0 : apart == 2 ? 1.0 : 2.0) / 36.0;
  const double n = static_cast<double>(nodes);
  return (apart == 0 ? 2.0 : 1.0) / (n * (n + 1.0));
}

}  // namespace

void add_stress_growth(const Net& net, const BorderPiece& piece, const StressGradient& gradient, const Vector& centre,
                       std::span<double> forces) {
  const std::size_t count = piece.nodes.size();
  const double measure = piece.share * static_cast<double>(count);  // the thickness in the plane
  for (std::size_t j = 0; j < count; ++j) {
    const Vector pull = growth(gradient, net.nodes[piece.nodes[j]] - centre) * piece.area;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t axis = 0; axis < net.dimension; ++axis)
        forces[net.freedoms().at(piece.nodes[i], axis)] += measure * shared(count, i > j ? i - j : j - i) * pull[axis];
  }
}

std::vector<std::size_t> side_nodes(const Net& net, std::size_t axis, End end) {
  const Extent box = extent_of(net.body);
  const double position = end == End::low ? box.low[axis] : box.high[axis], tolerance = border_tolerance(net.body);
  const auto on_side = [&](std::size_t i) { return std::abs(net.nodes[i][axis] - position) <= tolerance; };
  std::vector<std::size_t> nodes;
  if (!net.outlines.empty()) {
    std::ranges::copy_if(net.outlines[0], std::back_inserter(nodes), on_side);
    std::ranges::sort(nodes);
  } else {
    for (std::size_t i = 0; i < net.nodes.size(); ++i)
      if (net.on_border(i) && on_side(i)) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace nodal::elastic
