// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "finite_elements/plane_graph.h"
#include "finite_elements/plane_mesh.h"

namespace nodal::elastic::finite_elements {

namespace {

// Where the pieces at a place lead.
std::vector<std::vector<std::size_t>> interface_neighbours(const PlaneGraph& graph) {
  std::vector<std::vector<std::size_t>> neighbours(graph.places.size());
  for (const auto& [from, to] : graph.interfaces) {
    neighbours[from].push_back(to);
    neighbours[to].push_back(from);
  }
  return neighbours;
}

double turn_at(const plane::Point& from, const plane::Point& at, const plane::Point& to) {
  const double ax = at[0] - from[0], ay = at[1] - from[1], bx = to[0] - at[0], by = to[1] - at[1];
  return std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by));
}

}  // namespace

std::vector<plane::Point> singular_interface_places(const PlaneBody& body, double turn) {
  const PlaneGraph graph = plane_graph(body);
  const auto neighbours = interface_neighbours(graph);
  std::vector<char> on_border(graph.places.size(), 0);
  for (const auto& piece : graph.border) on_border[piece[0]] = 1;
  std::vector<plane::Point> singular;
  for (std::size_t at = 0; at < graph.places.size(); ++at) {
    const auto& around = neighbours[at];
    const bool smooth =
        around.empty() || (around.size() == 2 && !on_border[at] &&
                           turn_at(graph.places[around[0]], graph.places[at], graph.places[around[1]]) <= turn);
    if (!smooth) singular.push_back(graph.places[at]);
  }
  return singular;
}

std::vector<plane::Point> interface_crossings(const PlaneBody& body) {
  const PlaneGraph graph = plane_graph(body);
  std::vector<std::size_t> sectors(graph.places.size(), 0);
  for (const auto& piece : graph.interfaces)
    for (const std::size_t end : piece) ++sectors[end];
  for (const auto& piece : graph.border)
    if (sectors[piece[0]] > 0) ++sectors[piece[0]];
  std::vector<plane::Point> crossings;
  for (std::size_t at = 0; at < graph.places.size(); ++at)
    if (sectors[at] > 2) crossings.push_back(graph.places[at]);
  return crossings;
}

}  // namespace nodal::elastic::finite_elements
