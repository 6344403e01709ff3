// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <nodal/error.h>

#include "points/block_points.h"
#include "springs/grid_springs.h"

namespace nodal::elastic {

namespace {

bool even(const BlockIndex& i) { return (i[0] + i[1] + i[2]) % 2 == 0; }

// A step to a neighbour: along an edge, across a face or through a cell.
struct Step {
  BlockIndex by{};
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

bool joins(std::string_view topology, const BlockIndex& from, const Step& step) {
  if (step.axes == 1 || topology == "crossed") return true;
  if (topology == "single") return step.rising;
  if (step.axes == 3) return false;
  if (topology == "faces") return true;
  const BlockIndex to = from + step.by;
  BlockIndex lowest{};
  for (std::size_t axis = 0; axis < 3; ++axis) lowest[axis] = std::min(from[axis], to[axis]);
  return even(lowest) == step.rising;
}

void add_tetrahedron(Net& net, std::array<std::size_t, 4> nodes, double share) {
  if (volume_of(net.nodes, nodes) < 0.0) std::swap(nodes[2], nodes[3]);
  net.tetrahedra.push_back({nodes, share});
}

// Kuhn's six about the diagonal from corner `from`: one along each way from there to the opposite corner.
void add_six(const Block& block, const BlockIndex& cell, unsigned from, double share, Net& net) {
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
void add_five(const Block& block, const BlockIndex& cell, bool even_corners, double share, Net& net) {
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

void add_tetrahedra(const Block& block, std::string_view topology, Net& net) {
  block.for_each_cell([&](const BlockIndex& cell) {
    if (topology == "single") add_six(block, cell, 0u, 1.0, net);
    if (topology == "crossed")
      for (const unsigned from : {0u, 1u, 2u, 3u}) add_six(block, cell, from, 0.25, net);
    if (topology == "alternating") add_five(block, cell, true, 1.0, net);
    if (topology == "faces")
      for (const bool even_corners : {true, false}) add_five(block, cell, even_corners, 0.5, net);
  });
}

}  // namespace

void join_block(Net& net, std::string_view topology) {
  constexpr std::array<std::string_view, 4> kKnown = {"single", "alternating", "faces", "crossed"};
  if (std::ranges::find(kKnown, topology) == kKnown.end())
    throw Refusal("a block can't be connected by '" + std::string(topology) + "'");
  net.topology = topology;
  const Block block(*net.body.box, {net.grid.columns, net.grid.rows, net.grid.layers});
  const std::vector<Step> steps = steps_ahead();
  block.for_each_node([&](const BlockIndex& i) {
    for (const Step& step : steps)
      if (const BlockIndex to = i + step.by; block.has(to) && joins(topology, i, step))
        net.springs.push_back(make_spring(net.nodes, block.node(i), block.node(to)));
  });
  add_tetrahedra(block, topology, net);
}

Net make_block_net(const Body& body, const std::array<std::size_t, 3>& counts, const std::string& topology) {
  Net net = place_block(body, counts);
  join_block(net, topology);
  return net;
}

}  // namespace nodal::elastic
