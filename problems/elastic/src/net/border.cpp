// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/border.h"

#include <algorithm>
#include <limits>

#include "geometry/plane/ring_tree.h"
#include "geometry/plane/segment.h"

namespace nodal::elastic {

namespace {

// Which vertices are corners.
std::vector<bool> corner_marks(const plane::Ring& ring, double turn) {
  std::vector<bool> marks(ring.size(), false);
  for (const std::size_t c : plane::corner_vertices(ring, turn)) marks[c] = true;
  return marks;
}

// The place of a node on a ring, of whose sides those nearby are given, ascending: at the nearest vertex, whose side is
// the one that begins there, else on the nearest side. False when it isn't on the ring.
bool find_on_ring(const plane::Point& node, const plane::RingTree& ring, const std::vector<std::size_t>& sides,
                  double tolerance, const std::vector<bool>& corners, NodeOnRing& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : sides) {
    const double away = plane::distance(node, ring.vertex(i));
    if (away > tolerance) continue;
    place.corner = place.corner || corners[i];
    if (away < nearest) nearest = away, place.side = i;
  }
  if (nearest <= tolerance) return true;
  for (const std::size_t i : sides) {
    const plane::Point &p = ring.vertex(i), &q = ring.vertex(i + 1);
    const double away = plane::distance_to_segment(node, p, q);
    if (away > tolerance || away >= nearest) continue;
    nearest = away;
    place.side = i;
    place.share = plane::nearest_share(node, p, q);
  }
  return nearest <= tolerance;
}

}  // namespace

std::vector<NodeOnRing> nodes_on_ring(const Net& net, std::size_t r) {
  const double tolerance = plane::outline_tolerance(net.body);
  const plane::RingTree ring(net.body.rings[r], 0);
  const std::vector<bool> corners = corner_marks(net.body.rings[r], net.body.corner_turn);
  const double margin = 2.0 * tolerance;  // a node at the tolerance itself may not fall through by rounding
  std::vector<NodeOnRing> found;
  std::vector<std::size_t> nearby;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const plane::Point node = in_plane(net.nodes[i]);
    nearby.clear();
    ring.collect({{node[0] - margin, node[1] - margin}, {node[0] + margin, node[1] + margin}}, nearby);
    NodeOnRing place{i, 0, 0.0, false};
    if (find_on_ring(node, ring, nearby, tolerance, corners, place)) found.push_back(place);
  }
  std::ranges::sort(found, [](const NodeOnRing& a, const NodeOnRing& b) {
    return a.side != b.side ? a.side < b.side : a.share != b.share ? a.share < b.share : a.node < b.node;
  });
  return found;
}

void find_border(Net& net) {
  const std::vector<plane::Ring>& rings = net.body.rings;
  net.kinds.assign(net.nodes.size(), NodeKind::inner);
  net.outlines.assign(rings.size(), {});
  if (rings.empty()) return;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const NodeOnRing& place : nodes_on_ring(net, r)) {
      net.kinds[place.node] = place.corner ? NodeKind::corner : NodeKind::border;
      net.outlines[r].push_back(place.node);
    }
}

}  // namespace nodal::elastic
