// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <nodal/elastic/net.h>

#include "body/segment.h"
#include "body/side_index.h"

namespace nodal::elastic {

namespace {

// Where on a ring a node lies.
struct OnRing {
  std::size_t node;
  std::size_t side;
  double share;  // of the side
  bool corner;   // at a corner of the ring
};

// Which vertices are corners.
std::vector<bool> corner_marks(const Ring& ring, double turn) {
  std::vector<bool> marks(ring.size(), false);
  for (const std::size_t c : corner_vertices(ring, turn)) marks[c] = true;
  return marks;
}

// The place of a node on a ring, of whose sides those nearby are given; a node at a vertex belongs to the side that
// begins there. False when it isn't on the ring.
bool find_on_ring(const Point& node, const Ring& ring, std::span<const RingPlace> sides, double tolerance,
                  const std::vector<bool>& corners, OnRing& place) {
  bool at_vertex = false;
  for (const auto [_, i] : sides) {
    if (distance(node, ring[i]) > tolerance) continue;
    if (!at_vertex) place.side = i;
    at_vertex = true;
    place.corner = place.corner || corners[i];
  }
  if (at_vertex) return true;
  for (const auto [_, i] : sides) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    if (distance_to_segment(node, p, q) > tolerance) continue;
    place.side = i;
    place.share = nearest_share(node, p, q);
    return true;
  }
  return false;
}

// Those of one ring, of places ordered by ring.
std::span<const RingPlace> of_ring(std::span<const RingPlace> places, std::size_t ring) {
  const auto begin = std::ranges::lower_bound(places, ring, {}, &RingPlace::ring);
  const auto end = std::ranges::upper_bound(begin, places.end(), ring, {}, &RingPlace::ring);
  return {begin, end};
}

// The nodes on one ring, along it.
std::vector<OnRing> nodes_on_ring(const Net& net, const SideIndex& index, std::size_t r) {
  const Ring& ring = net.body.rings[r];
  const std::vector<bool> corners = corner_marks(ring, net.body.corner_turn);
  std::vector<OnRing> found;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const std::span<const RingPlace> near = of_ring(index.near(net.nodes[i]), r);
    OnRing place{i, 0, 0.0, false};
    if (find_on_ring(net.nodes[i], ring, near, index.tolerance(), corners, place)) found.push_back(place);
  }
  std::ranges::sort(found, [](const OnRing& a, const OnRing& b) {
    return a.side != b.side ? a.side < b.side : a.share != b.share ? a.share < b.share : a.node < b.node;
  });
  return found;
}

}  // namespace

void find_border(Net& net) {
  const std::vector<Ring>& rings = net.body.rings;
  net.kinds.assign(net.nodes.size(), NodeKind::inner);
  net.outlines.assign(rings.size(), {});
  if (rings.empty()) return;
  const SideIndex index(rings);
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const OnRing& place : nodes_on_ring(net, index, r)) {
      net.kinds[place.node] = place.corner ? NodeKind::corner : NodeKind::border;
      net.outlines[r].push_back(place.node);
    }
}

}  // namespace nodal::elastic
