// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_net.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/plane/voronoi_cells.h"
#include "import/system_files.h"
#include "read/exclusive_keys.h"
#include "read/read_points.h"
#include "springs/connections.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

constexpr std::int64_t kDefaultNearest = 6;

void join(const std::vector<NodePair>& pairs, Net& net) {
  for (const auto& [i, j] : pairs) net.springs.push_back(make_spring(net.nodes, i, j));
}

void triangulate(Net& net) {
  net.triangles = net.body.has_outline() ? constrained_triangles(in_plane(net.nodes), net.outlines)
                                         : delaunay_triangles(in_plane(net.nodes));
  const std::size_t slivers = drop_slivers(in_plane(net.nodes), net.triangles, kLeastTriangleHeight);
  if (slivers > 0)
    net.remarks.push_back(
        fmt::format("{} sliver{} on the border, flatter than 1 : {}, {} left out: nodes there lie "
                    "nearly on a line",
                    slivers, slivers == 1 ? "" : "s", 1.0 / kLeastTriangleHeight, slivers == 1 ? "is" : "are"));
}

std::vector<NodePair> touching_regions(const Net& net) {
  const Outline outline(net.body);
  VoronoiCells cells(outline, {});
  cells.compute(in_plane(net.nodes));
  std::vector<NodePair> pairs = cells.neighbour_pairs();
  std::ranges::sort(pairs);
  return pairs;
}

void join_by(const std::string& topology, const Options& springs, Net& net) {
  net.topology = topology;
  if (topology == "nearest") {
    const std::int64_t count = springs.has("nearest") ? springs.integer("nearest") : kDefaultNearest;
    std::optional<Outline> outline;
    if (net.body.has_outline()) outline.emplace(net.body);
    net.topology = fmt::format("nearest {}", count);
    join(nearest_pairs(outline ? &*outline : nullptr, in_plane(net.nodes), static_cast<std::size_t>(count)), net);
    return;
  }
  if (topology == "voronoi-neighbours") {
    if (!net.body.has_outline())
      throw Refusal("Voronoi regions need a body with an outline; take springs = { topology = \"delaunay\" }");
    join(touching_regions(net), net);
    return;
  }
  triangulate(net);
  join(side_pairs(net.triangles), net);
  if (topology == "delaunay-flip") join(flip_pairs(in_plane(net.nodes), net.triangles), net);
}

}  // namespace

StudyNet read_net(const Options& problem, const ProblemContext& context, const Body& body) {
  const Options springs = problem.table("springs");
  refuse_both(springs, "file", "topology");
  refuse_both(springs, "file", "nearest");
  StudyPoints points = read_points(problem, context, body);
  StudyNet read{std::move(points.net), {}, {}};
  Net& net = read.net;
  if (springs.has("columns") && !springs.has("file"))
    throw InputError(springs.at("columns").source, "'columns' belongs to a 'file' of springs");
  if (springs.has("file")) {
    TableOptions options = read_table_options(springs);
    options.scale = read_table_options(problem.table("points")).scale;  // lengths are in the nodes' unit
    SpringFile file = read_spring_file(context.files, context.files.path(springs.text("file")), net, options);
    net.topology = fmt::format("from {}", springs.text("file"));
    net.grid = {};
    net.triangles.clear();
    net.springs = std::move(file.springs);
    read.stiffness = std::move(file.stiffness);
    read.groups = std::move(file.groups);
    read.bounds = file.bounds;
    return read;
  }
  const std::string topology = read_topology(problem, net.dimension);
  if (springs.has("nearest") && topology != "nearest")
    throw InputError(springs.at("nearest").source,
                     fmt::format("'nearest' belongs to topology 'nearest', and this one is '{}'", topology));
  if (points.joined) return read;
  if (is_grid_topology(topology)) {
    net.topology = topology;
    join(points.grid_pairs, net);
    if (!net.springs.empty()) return read;
    throw InputError(problem.table("points").values().source,
                     "the grid is so coarse that the body holds no spring of it");
  }
  try {
    join_by(topology, springs, net);
  } catch (const Refusal& refusal) {
    const Source& source = springs.has("topology") ? springs.at("topology").source : springs.values().source;
    throw InputError(source, fmt::format("topology '{}': {}", topology, refusal.what()));
  }
  return read;
}

}  // namespace nodal::elastic
