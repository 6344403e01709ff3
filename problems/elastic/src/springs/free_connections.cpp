// SPDX-License-Identifier: GPL-3.0-or-later
// Springs between any nodes of the plane.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/plane/voronoi_cells.h"
#include "springs/connection.h"
#include "springs/connections.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

constexpr std::int64_t kDefaultNearest = 6;

std::string lacking_library() { return triangulation_available() ? "" : triangulation_library(); }

void join(const std::vector<NodePair>& pairs, Net& net) {
  for (const auto& [i, j] : pairs) net.springs.push_back(make_spring(net.nodes, i, j));
}

void triangulate(Net& net, Account& account) {
  net.triangles = net.body.has_outline() ? plane::constrained_triangles(in_plane(net.nodes), net.outlines)
                                         : plane::delaunay_triangles(in_plane(net.nodes));
  const std::size_t slivers = drop_slivers(in_plane(net.nodes), net.triangles, kLeastTriangleHeight);
  if (slivers > 0)
    account.remark(
        fmt::format("{} sliver{} on the border, flatter than 1 : {}, {} left out: nodes there lie "
                    "nearly on a line",
                    slivers, slivers == 1 ? "" : "s", 1.0 / kLeastTriangleHeight, slivers == 1 ? "is" : "are"));
  account.used(kTriangulationStage, fmt::format("{} triangles within the outlines", net.triangles.size()));
}

std::vector<NodePair> touching_regions(const Net& net) {
  const plane::Outline outline(net.body);
  plane::VoronoiCells cells(outline, {});
  cells.compute(in_plane(net.nodes));
  std::vector<NodePair> pairs = cells.neighbour_pairs();
  std::ranges::sort(pairs);
  return pairs;
}

void join_delaunay(const Options& /*springs*/, LaidNodes& nodes, Account& account) {
  triangulate(nodes.net, account);
  join(side_pairs(nodes.net.triangles), nodes.net);
}

void join_delaunay_flip(const Options& springs, LaidNodes& nodes, Account& account) {
  join_delaunay(springs, nodes, account);
  join(flip_pairs(in_plane(nodes.net.nodes), nodes.net.triangles), nodes.net);
}

void join_voronoi_neighbours(const Options& /*springs*/, LaidNodes& nodes, Account& /*account*/) {
  if (!nodes.net.body.has_outline())
    throw Refusal("Voronoi regions need a body with an outline; take springs = { topology = \"delaunay\" }");
  join(touching_regions(nodes.net), nodes.net);
}

void join_nearest(const Options& springs, LaidNodes& nodes, Account& /*account*/) {
  Net& net = nodes.net;
  const std::int64_t count = springs.has("nearest") ? springs.integer("nearest") : kDefaultNearest;
  std::optional<plane::Outline> outline;
  if (net.body.has_outline()) outline.emplace(net.body);
  net.topology = fmt::format("nearest {}", count);
  join(nearest_pairs(outline ? &*outline : nullptr, in_plane(net.nodes), static_cast<std::size_t>(count)), net);
}

OptionSchema nearest_options() {
  return {{.name = "nearest",
           .type = OptionType::integer,
           .default_text = std::to_string(kDefaultNearest),
           .minimum = 1,
           .maximum = 1000,
           .help = "with how many of its nearest nodes each is joined"}};
}

constexpr std::string_view kTriangulates = "CGAL";

}  // namespace

extern const Connection kDelaunayConnection = {.name = "delaunay",
                                               .summary = "the sides of the Delaunay triangles in the body",
                                               .needs = kTriangulates,
                                               .lacks = lacking_library,
                                               .make = join_delaunay};

extern const Connection kDelaunayFlipConnection = {
    .name = "delaunay-flip",
    .summary = "and across every inner side, between the opposite corners: about 6 springs per node",
    .needs = kTriangulates,
    .lacks = lacking_library,
    .make = join_delaunay_flip};

extern const Connection kVoronoiNeighboursConnection = {.name = "voronoi-neighbours",
                                                        .summary = "nodes whose Voronoi regions touch inside the body",
                                                        .needs = kTriangulates,
                                                        .lacks = lacking_library,
                                                        .make = join_voronoi_neighbours};

extern const Connection kNearestConnection = {.name = "nearest",
                                              .summary = "each node with its nearest ones, except across the outline",
                                              .options = nearest_options,
                                              .make = join_nearest};

}  // namespace nodal::elastic
