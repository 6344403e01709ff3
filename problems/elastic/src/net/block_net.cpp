// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/net.h>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

using Index = std::array<std::ptrdiff_t, 3>;  // of a node or a cell, along each axis

// The grid of nodes over a box.
class Block {
 public:
  Block(const Extent& box, const std::array<std::size_t, 3>& counts) : box_(box) {
    for (std::size_t axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::ptrdiff_t>(counts[axis]);
  }

  [[nodiscard]] std::ptrdiff_t count(std::size_t axis) const { return counts_[axis]; }
  [[nodiscard]] std::size_t node(const Index& i) const {
    return static_cast<std::size_t>((i[2] * counts_[1] + i[1]) * counts_[0] + i[0]);
  }
  [[nodiscard]] bool has(const Index& i) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (i[axis] < 0 || i[axis] >= counts_[axis]) return false;
    return true;
  }
  // Shares of the side, not sums of cells, so that the last node lies exactly on the border.
  [[nodiscard]] Vector place(const Index& i) const {
    Vector at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] =
          box_.low[axis] + box_.along(axis) * (static_cast<double>(i[axis]) / static_cast<double>(counts_[axis] - 1));
    return at;
  }
  [[nodiscard]] NodeKind kind(const Index& i) const {
    int ends = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) ends += i[axis] == 0 || i[axis] == counts_[axis] - 1;
    return ends == 3 ? NodeKind::corner : ends > 0 ? NodeKind::border : NodeKind::inner;
  }
  [[nodiscard]] Vector cell() const {
    Vector size{};
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = box_.along(axis) / static_cast<double>(counts_[axis] - 1);
    return size;
  }

  template <class Visit>
  void for_each_node(Visit visit) const {
    for_each(counts_, visit);
  }
  template <class Visit>
  void for_each_cell(Visit visit) const {
    for_each({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}, visit);
  }

 private:
  template <class Visit>
  static void for_each(const Index& counts, Visit visit) {
    for (std::ptrdiff_t k = 0; k < counts[2]; ++k)
      for (std::ptrdiff_t j = 0; j < counts[1]; ++j)
        for (std::ptrdiff_t i = 0; i < counts[0]; ++i) visit(Index{i, j, k});
  }

  Extent box_;
  Index counts_{};
};

Index operator+(const Index& a, const Index& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

bool even(const Index& i) { return (i[0] + i[1] + i[2]) % 2 == 0; }

// A step to a neighbour: along an edge, across a face or through a cell.
struct Step {
  Index by{};
  int axes = 0;         // how many it goes along
  bool rising = false;  // all of them the same way: a diagonal that starts at a lowest corner
};

// To the 13 neighbours with a higher number, lowest first.
std::vector<Step> steps_ahead() {
  std::vector<Step> steps;
  for (std::ptrdiff_t z = 0; z <= 1; ++z)
    for (std::ptrdiff_t y = z > 0 ? -1 : 0; y <= 1; ++y)
      for (std::ptrdiff_t x = z > 0 || y > 0 ? -1 : 1; x <= 1; ++x)
        if (z > 0 || y > 0 || x > 0) {
          const bool falls = x < 0 || y < 0;
          steps.push_back({{x, y, z}, (x != 0) + (y != 0) + (z != 0), !falls});
        }
  return steps;
}

bool joins(const std::string& topology, const Index& from, const Step& step) {
  if (step.axes == 1 || topology == "crossed") return true;
  if (topology == "single") return step.rising;
  if (step.axes == 3) return false;
  if (topology == "faces") return true;
  const Index to = from + step.by;
  Index lowest{};
  for (std::size_t axis = 0; axis < 3; ++axis) lowest[axis] = std::min(from[axis], to[axis]);
  return even(lowest) == step.rising;
}

double volume(const Net& net, const std::array<std::size_t, 4>& t) {
  const Vector &o = net.nodes[t[0]], a = net.nodes[t[1]] - o, b = net.nodes[t[2]] - o, c = net.nodes[t[3]] - o;
  return dot(cross(a, b), c) / 6.0;
}

void add_tetrahedron(Net& net, std::array<std::size_t, 4> nodes, double share) {
  if (volume(net, nodes) < 0.0) std::swap(nodes[2], nodes[3]);
  net.tetrahedra.push_back({nodes, share});
}

// A corner of a cell, by one bit per axis.
Index corner_of(const Index& cell, unsigned bits) {
  return cell + Index{static_cast<std::ptrdiff_t>(bits & 1u), static_cast<std::ptrdiff_t>(bits >> 1u & 1u),
                      static_cast<std::ptrdiff_t>(bits >> 2u & 1u)};
}

// Kuhn's six about the diagonal from corner `from`: one along each way from there to the opposite corner.
void add_six(const Block& block, const Index& cell, unsigned from, double share, Net& net) {
  std::array<unsigned, 3> axes = {1u, 2u, 4u};
  do {
    const unsigned second = from ^ axes[0], third = second ^ axes[1], last = third ^ axes[2];
    add_tetrahedron(net,
                    {block.node(corner_of(cell, from)), block.node(corner_of(cell, second)),
                     block.node(corner_of(cell, third)), block.node(corner_of(cell, last))},
                    share);
  } while (std::ranges::next_permutation(axes).found);
}

// The tetrahedron of the four corners that face diagonals join, and the one cut off at each of the other four.
void add_five(const Block& block, const Index& cell, bool even_corners, double share, Net& net) {
  const auto node = [&](unsigned bits) { return block.node(corner_of(cell, bits)); };
  const auto joined = [&](unsigned bits) { return even(corner_of(cell, bits)) == even_corners; };
  std::array<std::size_t, 4> inner{};
  std::size_t found = 0;
  for (unsigned bits = 0; bits < 8; ++bits) {
    if (joined(bits))
      inner[found++] = node(bits);
    else
      add_tetrahedron(net, {node(bits), node(bits ^ 1u), node(bits ^ 2u), node(bits ^ 4u)}, share);
  }
  add_tetrahedron(net, inner, share);
}

void add_tetrahedra(const Block& block, const std::string& topology, Net& net) {
  block.for_each_cell([&](const Index& cell) {
    if (topology == "single") add_six(block, cell, 0u, 1.0, net);
    if (topology == "crossed")
      for (const unsigned from : {0u, 1u, 2u, 3u}) add_six(block, cell, from, 0.25, net);
    if (topology == "alternating") add_five(block, cell, true, 1.0, net);
    if (topology == "faces")
      for (const bool even_corners : {true, false}) add_five(block, cell, even_corners, 0.5, net);
  });
}

// The surface, a quad per outer face of a cell.
void add_border(const Block& block, Net& net) {
  const Vector size = block.cell();
  block.for_each_cell([&](const Index& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
      for (const std::ptrdiff_t end : {std::ptrdiff_t{0}, std::ptrdiff_t{1}}) {
        if (cell[axis] != (end == 0 ? 0 : block.count(axis) - 2)) continue;
        const unsigned at = end == 0 ? 0u : 1u << axis;
        Facet facet;
        std::size_t corner = 0;
        for (const unsigned around : {0u, 1u << p, 1u << p | 1u << q, 1u << q})
          facet.nodes[corner++] = block.node(corner_of(cell, at | around));
        facet.area[axis] = (end == 0 ? -1.0 : 1.0) * size[p] * size[q];
        net.border.push_back(facet);
      }
    }
  });
}

}  // namespace

Net make_block_net(const Body& body, const std::array<std::size_t, 3>& counts, const std::string& topology) {
  if (!body.box) throw Refusal("a block of nodes needs a body that is a box");
  if (*std::ranges::min_element(counts) < 2) throw Refusal("a block needs at least 2 × 2 × 2 nodes");
  constexpr std::array<const char*, 4> known = {"single", "alternating", "faces", "crossed"};
  if (std::ranges::find(known, topology) == known.end())
    throw Refusal("a block can't be connected by '" + topology + "'");
  const Block block(*body.box, counts);
  Net net;
  net.dimension = 3;
  net.body = body;
  net.topology = topology;
  net.layout = fmt::format("grid of {} × {} × {} nodes", counts[0], counts[1], counts[2]);
  net.grid = {counts[0], counts[1], block.cell(), counts[2]};
  block.for_each_node([&](const Index& i) {
    net.nodes.push_back(block.place(i));
    net.kinds.push_back(block.kind(i));
  });
  const std::vector<Step> steps = steps_ahead();
  block.for_each_node([&](const Index& i) {
    for (const Step& step : steps)
      if (const Index to = i + step.by; block.has(to) && joins(topology, i, step))
        net.springs.push_back(make_spring(net.nodes, block.node(i), block.node(to)));
  });
  add_tetrahedra(block, topology, net);
  add_border(block, net);
  return net;
}

}  // namespace nodal::elastic
