// SPDX-License-Identifier: GPL-3.0-or-later
// Springs between neighbours in a grid.
#include <fmt/format.h>

#include <nodal/error.h>

#include "springs/connection.h"
#include "springs/grid_springs.h"

namespace nodal::elastic {

namespace {

// Of a grid that is clipped to the body: only springs that lie in it.
void join_clipped(LaidNodes& nodes) {
  Net& net = nodes.net;
  const plane::GridPoints& grid = *nodes.clipped;
  const plane::Outline outline(net.body);
  const auto springs = plane::join_grid(outline, grid, net.topology);
  if (springs.empty()) throw Refusal("the grid is so coarse that the body holds no spring of it");
  for (const auto& [i, j] : springs) net.springs.push_back(make_spring(net.nodes, i, j));
  if (grid.cells == plane::GridCells::triangular) net.triangles = plane::grid_triangles(outline, grid, springs);
}

void join(const Options& /*springs*/, LaidNodes& nodes, Account& /*account*/) {
  const std::string topology = nodes.net.topology;
  if (nodes.net.body.box)
    join_block(nodes.net, topology);
  else if (nodes.clipped)
    join_clipped(nodes);
  else
    join_counted_grid(nodes.net, topology);
}

}  // namespace

extern const Connection kSingleConnection = {
    .name = "single",
    .summary = "one diagonal in each cell and, in space, in each face, all from its lowest corner",
    .in_space = true,
    .layout = "grid",
    .make = join};

extern const Connection kAlternatingConnection = {
    .name = "alternating",
    .summary = "one diagonal in each cell, in space in each face, in a chequered pattern",
    .in_space = true,
    .layout = "grid",
    .make = join};

extern const Connection kCrossedConnection = {
    .name = "crossed",
    .summary = "all diagonals: both in each cell; in space both of each face and four through each cell",
    .in_space = true,
    .layout = "grid",
    .make = join};

extern const Connection kFacesConnection = {.name = "faces",
                                            .summary = "both diagonals of each face, and none through the cells",
                                            .in_plane = false,
                                            .in_space = true,
                                            .layout = "grid",
                                            .make = join};

extern const Connection kGridConnection = {.name = "grid",
                                           .summary = "no diagonals, so its cells shear without resistance",
                                           .in_space = true,
                                           .layout = "grid",
                                           .mechanism = true,
                                           .make = join};

extern const Connection kTriangularConnection = {
    .name = "triangular", .summary = "the three directions of a triangular grid", .layout = "triangular", .make = join};

}  // namespace nodal::elastic
