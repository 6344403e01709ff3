// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/read_net.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "files/system_files.h"

namespace nodal::elastic {

namespace {

constexpr double kMostNodes = 1e6;

void refuse_with(const Options& table, const char* key, const char* other) {
  if (table.has(key) && table.has(other))
    throw InputError(table.at(key).source, fmt::format("'{}' and '{}' exclude each other", key, other));
}

// The topology by which nodal is to join nodes.
std::string read_topology(const Options& springs) {
  const std::string topology = springs.has("topology") ? springs.text("topology") : "crossed";
  const Source& source = springs.has("topology") ? springs.at("topology").source : springs.values().source;
  const auto known = std::ranges::find(topologies(), topology, &Topology::name);
  if (known == topologies().end()) {
    std::vector<std::string> names;
    for (const Topology& t : topologies()) names.push_back(t.name);
    throw InputError(source, fmt::format("unknown topology '{}'{}", topology, name_hint(topology, names)));
  }
  if (known->mechanism)
    throw InputError(source, fmt::format("topology '{}' is a mechanism: without diagonals its cells shear without "
                                         "resistance; take 'single', 'alternating' or 'crossed'",
                                         topology));
  return topology;
}

std::vector<double> read_counts(const Options& points) {
  const std::vector<double> counts = points.has("counts") ? points.numbers("counts") : std::vector{5.0, 5.0};
  const Source& source = points.has("counts") ? points.at("counts").source : points.values().source;
  for (const double count : counts)
    if (count < 2)
      throw InputError(source, fmt::format("'counts' is [{}, {}]: a grid with one row or column has no area; give at "
                                           "least 2 nodes in each direction",
                                           counts[0], counts[1]));
  if (counts[0] * counts[1] > kMostNodes)
    throw InputError(source, fmt::format("'counts' is [{}, {}]: more than {} nodes", counts[0], counts[1], kMostNodes));
  return counts;
}

Net read_grid(const Options& points, const Options& springs, const Body& body) {
  const std::vector<double> counts = read_counts(points);
  const std::string topology = springs.has("file") ? "crossed" : read_topology(springs);
  try {
    return make_grid_net(body, static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1]), topology);
  } catch (const std::invalid_argument& error) {
    throw InputError(points.values().source, error.what());
  }
}

Net read_points(const Options& points, const Options& springs, const ProblemContext& context, const Body& body) {
  refuse_with(points, "file", "counts");
  const std::string layout = points.has("layout") ? points.text("layout") : points.has("file") ? "file" : "grid";
  if (layout == "grid") {
    if (points.has("file")) throw InputError(points.at("file").source, "layout = 'grid' takes no 'file'");
    return read_grid(points, springs, body);
  }
  if (!points.has("file")) throw InputError(points.values().source, "layout = 'file' needs a 'file' with the nodes");
  Net net;
  net.body = body;
  read_node_file(context.directory / points.text("file"), net);
  find_border(net);
  return net;
}

}  // namespace

OptionSchema points_fields() {
  return {
      {.name = "layout",
       .type = OptionType::text,
       .default_text = "file where one is given, else grid",
       .choices = {"grid", "file"},
       .help = "how nodes are placed"},
      {.name = "counts",
       .type = OptionType::integer_list,
       .default_text = "[5, 5]",
       .length = 2,
       .help = "of a grid: nodes in x and in y, each at least 2"},
      {.name = "file",
       .type = OptionType::text,
       .help = "nodes of your own: CSV with columns x, y and if you like node (a number that names it) and mass, or a "
               "system file as 'nodal fit --export' writes it"},
  };
}

StudyNet read_net(const Options& problem, const ProblemContext& context, const Body& body) {
  const Options points = problem.table("points"), springs = problem.table("springs");
  refuse_with(springs, "file", "topology");
  StudyNet read;
  read.net = read_points(points, springs, context, body);
  if (springs.has("file")) {
    SpringFile file = read_spring_file(context.directory / springs.text("file"), read.net);
    read.net.topology = fmt::format("from {}", springs.text("file"));
    read.net.grid = {};
    read.net.triangles.clear();
    read.net.springs = std::move(file.springs);
    read.stiffness = std::move(file.stiffness);
    read.groups = std::move(file.groups);
  } else if (read.net.springs.empty()) {
    throw InputError(springs.values().source, "nodes from a file need springs = { file = … }");
  }
  return read;
}

}  // namespace nodal::elastic
