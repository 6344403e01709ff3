// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <nodal/elastic/net.h>

#include "body/segment.h"

namespace nodal::elastic {

namespace {

struct OnRing {
  std::size_t node;
  std::size_t side;
  double share;  // of the side
};

bool on_a_corner(const Point& node, const Ring& ring, const std::vector<std::size_t>& corners, double tolerance) {
  return std::ranges::any_of(corners, [&](std::size_t c) { return distance(node, ring[c]) <= tolerance; });
}

// The place of a node on a ring; a node at a vertex belongs to the side that begins there.
bool find_on_ring(const Point& node, const Ring& ring, double tolerance, OnRing& place) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance(node, ring[i]) <= tolerance) {
      place.side = i;
      place.share = 0.0;
      return true;
    }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    if (distance_to_segment(node, p, q) > tolerance) continue;
    place.side = i;
    place.share = nearest_share(node, p, q);
    return true;
  }
  return false;
}

}  // namespace

void find_border(Net& net) {
  const std::vector<Ring>& rings = net.body.rings;
  net.kinds.assign(net.nodes.size(), NodeKind::inner);
  net.outlines.assign(rings.size(), {});
  if (rings.empty()) return;
  const double tolerance = kOnOutline * bounding_box(rings[0]).size();
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::vector<std::size_t> corners = corner_vertices(rings[r], net.body.corner_turn);
    std::vector<OnRing> found;
    for (std::size_t i = 0; i < net.nodes.size(); ++i) {
      OnRing place{i, 0, 0.0};
      if (!find_on_ring(net.nodes[i], rings[r], tolerance, place)) continue;
      found.push_back(place);
      net.kinds[i] = on_a_corner(net.nodes[i], rings[r], corners, tolerance) ? NodeKind::corner : NodeKind::border;
    }
    std::ranges::sort(found, [](const OnRing& a, const OnRing& b) {
      return a.side != b.side ? a.side < b.side : a.share != b.share ? a.share < b.share : a.node < b.node;
    });
    for (const OnRing& place : found) net.outlines[r].push_back(place.node);
  }
}

}  // namespace nodal::elastic
