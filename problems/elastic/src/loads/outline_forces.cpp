// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/outline_forces.h"

#include <algorithm>
#include <cmath>

namespace nodal::elastic {

void for_each_outline_piece(const Net& net, const std::function<void(const OutlinePiece&)>& visit) {
  for (std::size_t r = 0; r < net.outlines.size(); ++r) {
    const std::vector<std::size_t>& nodes = net.outlines[r];
    if (nodes.size() < 2) continue;
    for (std::size_t i = 0; i < nodes.size(); ++i) visit({r, nodes[i], nodes[(i + 1) % nodes.size()]});
  }
}

void add_stress(const Net& net, const OutlinePiece& piece, const Stress& stress, std::span<double> forces) {
  const Vector &p = net.nodes[piece.from], &q = net.nodes[piece.to];
  const double nx = q[1] - p[1], ny = p[0] - q[0];  // the outer normal times the length
  const double fx = 0.5 * net.body.thickness * (stress[0] * nx + stress[2] * ny);
  const double fy = 0.5 * net.body.thickness * (stress[2] * nx + stress[1] * ny);
  for (const std::size_t node : {piece.from, piece.to}) {
    forces[net.freedoms().at(node, 0)] += fx;
    forces[net.freedoms().at(node, 1)] += fy;
  }
}

std::vector<std::size_t> box_side_nodes(const Net& net, std::size_t axis, End end) {
  if (!net.body.has_outline()) return {};
  const plane::Box box = plane::bounding_box(net.body.rings[0]);
  const double position = end == End::low ? box.low[axis] : box.high[axis];
  const double tolerance = plane::outline_tolerance(net.body);
  std::vector<std::size_t> nodes;
  for (const std::size_t i : net.outlines.at(0))
    if (std::abs(net.nodes[i][axis] - position) <= tolerance) nodes.push_back(i);
  std::ranges::stable_sort(nodes, {}, [&](std::size_t i) { return net.nodes[i][1 - axis]; });
  return nodes;
}

}  // namespace nodal::elastic
