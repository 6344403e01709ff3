// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace nodal::elastic::finite_elements {

namespace {

using Corners = std::vector<std::size_t>;

// A simplex's sides by its vertices, so that its material is to the left, in space behind them.
const std::vector<Corners>& sides_of_simplex(std::size_t dimension) {
  static const std::array<std::vector<Corners>, 4> kSides = {
      {{}, {}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}};
  return kSides[dimension];
}

// The middle of every edge, made when it is first asked for: in a list per edge's lower vertex.
class Middles {
 public:
  explicit Middles(std::vector<Vector>& nodes) : nodes_(nodes), first_(nodes.size(), kNone) {}

  std::size_t of(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(a, b);
    for (std::size_t e = first_[low]; e != kNone; e = edges_[e].next)
      if (edges_[e].high == high) return edges_[e].middle;
    edges_.push_back({high, nodes_.size(), first_[low]});
    first_[low] = edges_.size() - 1;
    Vector middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = 0.5 * (nodes_[low][axis] + nodes_[high][axis]);
    nodes_.push_back(middle);
    return edges_.back().middle;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  struct Edge {
    std::size_t high, middle, next;
  };
  std::vector<Vector>& nodes_;
  std::vector<std::size_t> first_;
  std::vector<Edge> edges_;
};

// Vertices, then middles.
void append_simplex(std::span<const std::size_t> vertices, Middles& middles, std::vector<std::size_t>& nodes) {
  nodes.insert(nodes.end(), vertices.begin(), vertices.end());
  const std::size_t edges = vertices.size() * (vertices.size() - 1) / 2;
  for (std::size_t e = 0; e < edges; ++e) nodes.push_back(middles.of(vertices[kEdges[e][0]], vertices[kEdges[e][1]]));
}

Corners sorted(Corners corners) {
  std::ranges::sort(corners);
  return corners;
}

// Which side of the linear mesh has these corners, sorted.
std::map<Corners, std::size_t> sides_by_corners(const LinearMesh& linear) {
  const std::size_t d = linear.dimension;
  std::map<Corners, std::size_t> found;
  for (std::size_t s = 0; s < linear.side_label.size(); ++s) {
    const auto begin = linear.sides.begin() + static_cast<std::ptrdiff_t>(s * d);
    found.emplace(sorted(Corners(begin, begin + static_cast<std::ptrdiff_t>(d))), s);
  }
  return found;
}

struct TurnedSide {
  Corners corners = {};  // in the order in which its cell has them
  std::size_t cell = 0;
};

std::vector<TurnedSide> sides_of_cells(const LinearMesh& linear) {
  const auto wanted = sides_by_corners(linear);
  std::vector<char> on_border(linear.vertices.size(), 0);
  for (const std::size_t vertex : linear.sides) on_border[vertex] = 1;
  std::vector<TurnedSide> turned(linear.side_label.size());
  const std::size_t corners = linear.dimension + 1;
  for (std::size_t c = 0; c < linear.region.size(); ++c) {
    for (const Corners& local : sides_of_simplex(linear.dimension)) {
      Corners side;
      for (const std::size_t k : local) side.push_back(linear.cells[c * corners + k]);
      if (!std::ranges::all_of(side, [&](std::size_t v) { return on_border[v]; })) continue;
      if (const auto found = wanted.find(sorted(side)); found != wanted.end()) turned[found->second] = {side, c};
    }
  }
  return turned;
}

}  // namespace

LinearMesh without_unused(LinearMesh linear) {
  std::vector<std::size_t> number(linear.vertices.size(), 0);
  for (const std::size_t vertex : linear.cells) number[vertex] = 1;
  std::size_t used = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    linear.vertices[used] = linear.vertices[v];
    number[v] = used++;
  }
  linear.vertices.resize(used);
  for (auto* vertices : {&linear.cells, &linear.sides})
    for (std::size_t& vertex : *vertices) vertex = number[vertex];
  return linear;
}

Mesh quadratic(const LinearMesh& linear) {
  Mesh mesh;
  mesh.dimension = linear.dimension;
  mesh.nodes = linear.vertices;
  mesh.region = linear.region;
  mesh.side_label = linear.side_label;
  mesh.cells.reserve(linear.region.size() * mesh.nodes_per_cell());
  Middles middles(mesh.nodes);
  const std::size_t corners = linear.dimension + 1;
  for (std::size_t c = 0; c < linear.region.size(); ++c)
    append_simplex(std::span(linear.cells).subspan(c * corners, corners), middles, mesh.cells);
  for (const TurnedSide& side : sides_of_cells(linear)) {
    if (side.corners.empty()) throw std::logic_error("finite_elements::quadratic: a side is no cell's");
    append_simplex(side.corners, middles, mesh.sides);
    mesh.side_cell.push_back(side.cell);
  }
  return mesh;
}

}  // namespace nodal::elastic::finite_elements
