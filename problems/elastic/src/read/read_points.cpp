// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_points.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/random.h>
#include <nodal/shown.h>

#include "import/system_files.h"
#include "points/grid_points.h"
#include "points/iterated_voronoi.h"
#include "points/random_points.h"
#include "points/written_places.h"
#include "read/exclusive_keys.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

std::string layout_of(const Options& points) {
  if (points.has("layout")) return points.text("layout");
  return points.has("file") ? "file" : "grid";
}

// Which keys go with which layouts.
struct LayoutKey {
  const char* name;
  std::vector<std::string> layouts;
};

const std::vector<LayoutKey>& layout_keys() {
  static const std::vector<LayoutKey> keys = {
      {"counts", {"grid"}},
      {"cell", {"grid"}},
      {"spacing", {"grid", "triangular"}},
      {"total", {"random", "voronoi"}},
      {"inner", {"random", "voronoi"}},
      {"border", {"random", "voronoi"}},
      {"border_spread", {"random", "voronoi"}},
      {"density", {"random", "voronoi"}},
      {"seed", {"random", "voronoi"}},
      {"iterations", {"voronoi"}},
      {"tolerance", {"voronoi"}},
      {"file", {"file"}},
      {"columns", {"file"}},
      {"scale", {"file"}},
  };
  return keys;
}

void refuse_foreign_keys(const Options& points, const std::string& layout) {
  for (const LayoutKey& key : layout_keys())
    if (points.has(key.name) && std::ranges::find(key.layouts, layout) == key.layouts.end())
      throw InputError(points.at(key.name).source, fmt::format("'{}' belongs to layout '{}', and this one is '{}'",
                                                               key.name, fmt::join(key.layouts, "' or '"), layout));
}

std::vector<double> read_counts(const Options& points, std::size_t dimension) {
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
  return counts;
}

// A grid of nodes in a box; no other layout fills one.
StudyPoints read_block(const Options& points, const std::string& topology, const Body& body) {
  const std::vector<double> counts = read_counts(points, 3);
  const auto count = [&](std::size_t axis) { return static_cast<std::size_t>(counts[axis]); };
  return at(points.values().source, [&] {
    StudyPoints read;
    read.net = make_block_net(body, {count(0), count(1), count(2)}, topology);
    read.joined = true;
    return read;
  });
}

// A grid of so many nodes over a rectangle; other springs than a grid's own are made later.
StudyPoints read_counted_grid(const Options& points, const std::string& topology, const Body& body) {
  const std::vector<double> counts = read_counts(points, 2);
  const bool joined = is_grid_topology(topology);
  const auto make = [&] {
    StudyPoints read;
    read.net = make_grid_net(body, static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1]),
                             joined ? topology : "crossed");
    read.joined = joined;
    if (!joined) {
      read.net.grid = {};
      read.net.springs.clear();
    }
    return read;
  };
  return at(points.values().source, make,
            "give points = { spacing = 0.5 }, and a grid with such cells, in metres, is clipped to the body");
}

Net net_of(const Body& body, std::vector<Point> nodes) {
  Net net;
  net.body = body;
  net.nodes = lifted(nodes);
  find_border(net);
  return net;
}

// A grid clipped to the body. Its own topologies join exactly its nodes; for others the outline gets nodes too.
StudyPoints read_clipped_grid(const Options& points, const std::string& topology, const Body& body,
                              const Outline& outline) {
  const bool triangular = layout_of(points) == "triangular";
  if (triangular && !points.has("spacing"))
    throw InputError(points.values().source,
                     "layout 'triangular' needs a spacing: points = { layout = \"triangular\", spacing = 0.5 }");
  refuse_both(points, "spacing", "cell");
  refuse_both(points, "counts", points.has("spacing") ? "spacing" : "cell");
  Point cell{};
  if (points.has("cell"))
    cell = {points.numbers("cell")[0], points.numbers("cell")[1]};
  else
    cell = {points.number("spacing"), points.number("spacing")};
  const GridCells cells = triangular ? GridCells::triangular : GridCells::rectangular;
  StudyPoints read;
  std::string form;
  if (is_grid_topology(topology)) {
    const GridPoints grid = make_exact_grid(outline, cell, cells);
    read.net = net_of(body, grid.points.points);
    const auto springs = join_grid(outline, grid, topology);
    for (const auto& [i, j] : springs) read.grid_pairs.emplace_back(i, j);
    if (triangular) read.net.triangles = grid_triangles(outline, grid, springs);
    form = "clipped to the body";
  } else {
    read.net = net_of(body, make_fitted_grid(outline, cell, cells).points);
    form = "inside the body, and nodes along its outline";
  }
  read.net.layout = fmt::format(
      "{} nodes: a {} grid, {}", read.net.nodes.size(),
      triangular ? fmt::format("triangular {} m", cell[0]) : fmt::format("{} m × {} m", cell[0], cell[1]), form);
  return read;
}

Density read_density(const Options& points) {
  std::vector<DensitySpot> spots;
  if (points.has("density"))
    for (const Options& spot : points.tables("density")) {
      const std::vector<double> at = spot.numbers("at");
      spots.push_back({{at[0], at[1]}, spot.number("radius"), spot.number("factor")});
    }
  return Density(std::move(spots));
}

std::size_t count_of(const Options& points, const char* key) { return static_cast<std::size_t>(points.integer(key)); }

// The border of the least total of which that many are inner ones: as dense on the outline as inside. The more points,
// the more are inner ones, so the total is bisected for: a needle takes thousands of points around few.
std::size_t border_as_dense(const Outline& outline, std::size_t inner) {
  std::size_t low = inner + least_border_points(outline);
  std::size_t high = std::max(low, static_cast<std::size_t>(kMostNodes));
  if (share_points(outline, high).inner < inner)
    throw Refusal(fmt::format(
        "{} inner nodes, and as dense on an outline as long as this one, are more than {} nodes; say how many with "
        "'border'",
        inner, kMostNodes));
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (share_points(outline, middle).inner < inner)
      low = middle + 1;
    else
      high = middle;
  }
  return low - inner;
}

RandomPointsOptions read_numbers(const Options& points, const Outline& outline) {
  refuse_both(points, "total", "inner");
  if (points.has("total")) {
    refuse_both(points, "total", "border");
    return share_points(outline, count_of(points, "total"));
  }
  if (!points.has("inner"))
    throw InputError(points.values().source,
                     fmt::format("layout '{0}' needs how many points: points = {{ layout = \"{0}\", total "
                                 "= 100 }}, or 'inner' and if you like 'border'",
                                 layout_of(points)));
  const std::size_t inner = count_of(points, "inner");
  if (points.has("border")) return {.inner = inner, .border = count_of(points, "border")};
  return {.inner = inner, .border = border_as_dense(outline, inner)};
}

StudyPoints read_scattered(const Options& points, const Body& body, const Outline& outline) {
  if (layout_of(points) == "voronoi" && !triangulation_available())
    throw InputError(points.at("layout").source, fmt::format("layout 'voronoi' needs {}", triangulation_library()));
  RandomPointsOptions options = read_numbers(points, outline);
  const bool at_random = points.has("border_spread") && points.text("border_spread") == "at-random";
  options.spread = at_random ? BorderSpread::at_random : BorderSpread::evenly;
  options.density = read_density(points);
  const std::int64_t seed = points.has("seed") ? points.integer("seed") : 1;
  RandomStream random(hash64(fmt::format("points {}", seed)));
  PlacedPoints placed = make_random_points(outline, options, random);
  const std::string counted = fmt::format("{} inner and {} border nodes, random with seed {}", options.inner,
                                          placed.size() - options.inner, seed);
  StudyPoints read;
  if (layout_of(points) == "random") {
    read.net = net_of(body, std::move(placed.points));
    read.net.layout = counted;
    return read;
  }
  VoronoiOptions voronoi;
  if (points.has("iterations")) voronoi.iterations = count_of(points, "iterations");
  if (points.has("tolerance")) voronoi.tolerance = points.number("tolerance");
  voronoi.density = options.density;
  IteratedVoronoi result = iterate_voronoi(outline, std::move(placed), voronoi);
  read.net = net_of(body, std::move(result.points.points));
  read.net.history = std::move(result.history);
  read.net.cells = std::move(result.cells);
  read.net.layout = fmt::format("{}, then {} iterations of Voronoi regions", counted, read.net.history.size() - 1);
  return read;
}

}  // namespace

bool is_grid_topology(const std::string& topology) {
  constexpr std::array<const char*, 6> names = {"single", "alternating", "crossed", "faces", "grid", "triangular"};
  return std::ranges::find(names, topology) != names.end();
}

std::string read_topology(const Options& problem, std::size_t dimension) {
  const Options springs = problem.table("springs");
  const std::string layout = layout_of(problem.table("points"));
  if (!springs.has("topology")) {
    if (layout == "grid") return "crossed";
    if (layout == "triangular") return layout;
    if (triangulation_available()) return "delaunay";
    throw InputError(springs.values().source,
                     fmt::format("topology 'delaunay', which suits these points, needs {}; springs = {{ topology = "
                                 "\"nearest\" }} doesn't",
                                 triangulation_library()));
  }
  const std::string& topology = springs.text("topology");
  const Source& source = springs.at("topology").source;
  const auto known = std::ranges::find(topologies(), topology, &Topology::name);
  if (known == topologies().end()) {
    std::vector<std::string> names;
    for (const Topology& t : topologies()) names.push_back(t.name);
    throw InputError(source, fmt::format("unknown topology '{}'{}", shown(topology), name_hint(topology, names)));
  }
  if (known->mechanism)
    throw InputError(source, fmt::format("topology '{}' is a mechanism: without diagonals its cells shear without "
                                         "resistance; take springs = {{ topology = \"crossed\" }}, or \"single\" or "
                                         "\"alternating\"",
                                         topology));
  if (dimension == 3 ? !known->in_space : !known->in_plane)
    throw InputError(source, fmt::format("topology '{}' is none {}; take springs = {{ topology = \"crossed\" }}",
                                         topology, dimension == 3 ? "in space" : "in the plane"));
  if (!known->lacks.empty()) throw InputError(source, fmt::format("topology '{}' needs {}", topology, known->lacks));
  const bool fits =
      !is_grid_topology(topology) || (topology == "triangular" ? layout == "triangular" : layout == "grid");
  if (!fits)
    throw InputError(source,
                     fmt::format("topology '{}' doesn't join points of layout '{}'; take springs = {{ topology = {} }}",
                                 topology, layout,
                                 layout == "triangular" ? "\"triangular\""
                                 : layout == "grid"     ? "\"crossed\""
                                                        : "\"delaunay\""));
  return topology;
}

StudyPoints read_points(const Options& problem, const ProblemContext& context, const Body& body) {
  const Options points = problem.table("points");
  const std::string layout = layout_of(points);
  refuse_foreign_keys(points, layout);
  if (layout == "file" && body.box)
    throw InputError(points.values().source,
                     "nodes of a file are read in the plane only; a box takes a grid: points = "
                     "{ counts = [5, 5, 5] }");
  if (layout == "file") {
    if (!points.has("file"))
      throw InputError(points.values().source,
                       "layout 'file' needs a file with the nodes: points = { file = \"nodes.csv\" }");
    StudyPoints read;
    read.net.body = body;
    read_node_file(context.files, context.files.path(points.text("file")), read.net, read_table_options(points));
    if (!problem.table("body").has("on_outline"))
      read.net.body.on_outline = on_outline_as_written(in_plane(read.net.nodes), body);
    find_border(read.net);
    return read;
  }
  if (body.box) {
    if (problem.table("springs").has("file"))
      throw InputError(problem.table("springs").at("file").source, "springs of a file are read in the plane only");
    if (layout != "grid" || points.has("spacing") || points.has("cell"))
      throw InputError(points.values().source, "a body in space takes a grid: points = { counts = [5, 5, 5] }");
    return read_block(points, read_topology(problem, 3), body);
  }
  if (!body.has_outline())
    throw InputError(
        points.values().source,
        fmt::format("layout '{}' needs a body with an outline, and this one has none; describe it, as by body = "
                    "{{ size = [4, 4] }}",
                    layout));
  // Springs of a file join the nodes that a grid has.
  const std::string topology = !problem.table("springs").has("file") ? read_topology(problem, 2)
                               : layout == "triangular"              ? layout
                                                                     : "crossed";
  const bool clipped = layout == "triangular" || points.has("spacing") || points.has("cell");
  if (layout == "grid" && !clipped) return read_counted_grid(points, topology, body);
  return at(points.values().source, [&] {
    const Outline outline(body);
    return clipped ? read_clipped_grid(points, topology, body, outline) : read_scattered(points, body, outline);
  });
}

}  // namespace nodal::elastic
