// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/marked_border.h"

#include "geometry/plane/segment.h"
#include "net/border.h"

namespace nodal::elastic {

namespace {

// A ring's vertices and the nodes between them, and how many nodes were passed up to each of them, its own too.
struct Vertices {
  plane::Ring places;
  std::vector<std::size_t> passed;
};

// Nodes that share a place share a vertex.
Vertices with_nodes(const plane::Ring& ring, const std::vector<NodeOnRing>& nodes, std::vector<plane::Point>& place) {
  Vertices vertices;
  std::size_t next = 0;
  const auto add = [&](const plane::Point& at) {
    if (!vertices.places.empty() && vertices.places.back() == at) {
      vertices.passed.back() = next;
      return;
    }
    vertices.places.push_back(at);
    vertices.passed.push_back(next);
  };
  for (std::size_t side = 0; side < ring.size(); ++side) {
    const plane::Point &p = ring[side], &q = ring[(side + 1) % ring.size()];
    add(p);
    for (; next < nodes.size() && nodes[next].side == side;) {
      const plane::Point at = plane::at_share(p, q, nodes[next].share);
      place[nodes[next++].node] = at;
      add(at);
    }
  }
  return vertices;
}

// Piece k of a ring lies between its k-th node and the next, the last one around its start.
std::vector<std::size_t> pieces_of(const Vertices& vertices, std::size_t first, std::size_t count) {
  std::vector<std::size_t> pieces;
  for (const std::size_t passed : vertices.passed)
    pieces.push_back(count < 2 ? kNoPiece : first + (passed + count - 1) % count);
  return pieces;
}

}  // namespace

MarkedBorder mark_border(const Net& net) {
  MarkedBorder border{{}, {}, in_plane(net.nodes)};
  std::size_t first = 0;
  for (std::size_t r = 0; r < net.body.rings.size(); ++r) {
    const Vertices vertices = with_nodes(net.body.rings[r], nodes_on_ring(net, r), border.place);
    const std::size_t count = net.outlines[r].size();
    border.pieces.push_back(pieces_of(vertices, first, count));
    if (count >= 2) first += count;
    border.rings.push_back(vertices.places);
  }
  return border;
}

}  // namespace nodal::elastic
