// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes in rows: so many over a rectangle or a box, or cells of a size clipped to any body.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "points/block_points.h"
#include "points/counted_grid.h"
#include "points/layout.h"
#include "tables/exclusive_keys.h"

namespace nodal::elastic {

namespace {

std::vector<std::size_t> read_counts(const Options& points, std::size_t dimension) {
  const std::vector<double> counts =
      points.has("counts") ? points.numbers("counts") : std::vector<double>(dimension, 5.0);
  const Source& source = points.has("counts") ? points.at("counts").source : points.values().source;
  if (counts.size() != dimension)
    throw InputError(source, fmt::format("'counts' has {} entries; a body {} needs {}", counts.size(),
                                         dimension == 3 ? "in space" : "in the plane", dimension));
  double nodes = 1.0;
  for (const double count : counts) {
    nodes *= count;
    if (count < 2)
      throw InputError(source, fmt::format("'counts' is [{}]: a grid with one row or column has no {}; give at "
                                           "least 2 nodes in each direction",
                                           fmt::join(counts, ", "), dimension == 3 ? "volume" : "area"));
  }
  if (nodes > kMostNodes)
    throw InputError(source, fmt::format("'counts' is [{}]: more than {} nodes", fmt::join(counts, ", "), kMostNodes));
  return {counts.begin(), counts.end()};
}

LaidNodes read_block(const Options& points, const LayoutRequest& request) {
  for (const char* key : {"spacing", "cell"})
    if (points.has(key))
      throw InputError(points.at(key).source,
                       fmt::format("'{}' belongs to grids in the plane; a grid in space is given "
                                   "by its nodes in each direction: points = {{ counts = [5, 5, "
                                   "5] }}",
                                   key));
  const std::vector<std::size_t> counts = read_counts(points, 3);
  request.account.used("points", fmt::format("grid of {} nodes", fmt::join(counts, " × ")));
  return {.net = place_block(request.body, {counts[0], counts[1], counts[2]})};
}

LaidNodes read_counted_grid(const Options& points, const LayoutRequest& request) {
  const std::vector<std::size_t> counts = read_counts(points, 2);
  request.account.used("points", fmt::format("grid of {} nodes", fmt::join(counts, " × ")));
  return at(
      points.values().source, [&] { return LaidNodes{.net = place_counted_grid(request.body, counts[0], counts[1])}; },
      "give points = { spacing = 0.5 }, and a grid with such cells, in metres, is clipped to the body");
}

// Exactly the grid's nodes for springs between neighbours; for others the outline gets nodes too.
LaidNodes read_clipped_grid(const LayoutRequest& request, plane::GridCells cells) {
  const Options points = request.problem.table("points");
  refuse_both(points, "spacing", "cell");
  refuse_both(points, "counts", points.has("spacing") ? "spacing" : "cell");
  plane::Point cell{};
  if (points.has("cell"))
    cell = {points.numbers("cell")[0], points.numbers("cell")[1]};
  else
    cell = {points.number("spacing"), points.number("spacing")};
  const plane::Outline outline(request.body);
  LaidNodes laid;
  if (request.neighbours_only) {
    plane::GridPoints grid = plane::make_exact_grid(outline, cell, cells);
    laid = lay(request.body, grid.points.points);
    laid.clipped = std::move(grid);
  } else {
    laid = lay(request.body, plane::make_fitted_grid(outline, cell, cells).points);
  }
  const char* form = request.neighbours_only ? "clipped to the body" : "inside the body, and nodes along its outline";
  request.account.used("points",
                       fmt::format("{} nodes: a {} grid, {}", laid.net.nodes.size(),
                                   cells == plane::GridCells::triangular ? fmt::format("triangular {} m", cell[0])
                                                                         : fmt::format("{} m × {} m", cell[0], cell[1]),
                                   form));
  return laid;
}

LaidNodes make_grid(const LayoutRequest& request) {
  const Options points = request.problem.table("points");
  if (request.body.box) return read_block(points, request);
  const bool clipped = points.has("spacing") || points.has("cell");
  return clipped ? read_clipped_grid(request, plane::GridCells::rectangular) : read_counted_grid(points, request);
}

LaidNodes make_triangular_grid(const LayoutRequest& request) {
  if (!request.problem.table("points").has("spacing"))
    throw Refusal("layout 'triangular' needs a spacing: points = { layout = \"triangular\", spacing = 0.5 }");
  return read_clipped_grid(request, plane::GridCells::triangular);
}

OptionSchema grid_options() {
  return {
      {.name = "counts",
       .type = OptionType::integer_list,
       .default_text = "[5, 5]; in space [5, 5, 5]",
       .length = 2,
       .longest = 3,
       .help = "so many nodes over a rectangle or box in x, in y and, in space, in z, each at least 2"},
      {.name = "spacing",
       .unit = "m",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "in the plane, between neighbours of a grid clipped to the body, the side of its square or triangular "
               "cells"},
      {.name = "cell",
       .type = OptionType::number_list,
       .unit = "m",
       .minimum = 0.0,
       .minimum_excluded = true,
       .length = 2,
       .help = "in the plane, instead of 'spacing': width and height of rectangular cells"},
  };
}

}  // namespace

extern const Layout kGridLayout = {.name = "grid",
                                   .summary = "a grid of square or rectangular cells",
                                   .connection = "crossed",
                                   .options = grid_options,
                                   .in_space = true,
                                   .make = make_grid};

extern const Layout kTriangularLayout = {.name = "triangular",
                                         .summary = "one of equilateral triangles",
                                         .connection = "triangular",
                                         .keys = {"spacing"},
                                         .make = make_triangular_grid};

}  // namespace nodal::elastic
