// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_net.h"

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "import/system_files.h"
#include "read/read_points.h"
#include "springs/connection.h"
#include "tables/exclusive_keys.h"

namespace nodal::elastic {

namespace {

// What joins the nodes of a layout where the study doesn't say.
const Connection& connection_of(const Layout& layout, const Options& springs) {
  const Connection& suits = *find_named(connections(), layout.connection);
  if (const std::string lacks = suits.lacking(); !lacks.empty())
    throw InputError(springs.values().source,
                     fmt::format("topology '{}', which suits these points, needs {}; springs = {{ topology = "
                                 "\"{}\" }} doesn't",
                                 suits.name, lacks, kNearestConnection.name));
  return suits;
}

const Connection& read_connection(const Options& springs, const Layout& layout, bool in_space) {
  if (!springs.has("topology")) return connection_of(layout, springs);
  const std::string& topology = springs.text("topology");
  const Source& source = springs.at("topology").source;
  const Connection* connection = find_named(connections(), topology);
  if (!connection)
    throw InputError(
        source, fmt::format("unknown topology '{}'{}", shown(topology), name_hint(topology, names_of(connections()))));
  if (connection->mechanism)
    throw InputError(source, fmt::format("topology '{}' is a mechanism: without diagonals its cells shear without "
                                         "resistance; take springs = {{ topology = \"crossed\" }}, or \"single\" or "
                                         "\"alternating\"",
                                         topology));
  if (in_space ? !connection->in_space : !connection->in_plane)
    throw InputError(source, fmt::format("topology '{}' is none {}; take springs = {{ topology = \"crossed\" }}",
                                         topology, in_space ? "in space" : "in the plane"));
  if (const std::string lacks = connection->lacking(); !lacks.empty())
    throw InputError(source, fmt::format("topology '{}' needs {}", topology, lacks));
  if (!connection->layout.empty() && connection->layout != layout.name)
    throw InputError(
        source, fmt::format("topology '{}' doesn't join points of layout '{}'; take springs = {{ topology = \"{}\" }}",
                            topology, layout.name, layout.connection));
  return *connection;
}

LaidNodes lay_nodes(const Layout& layout, const LayoutRequest& request) {
  LaidNodes nodes = at(request.problem.table("points").values().source, [&] { return layout.make(request); });
  request.account.left_out(kVoronoiStage, "no points were spread by them");
  return nodes;
}

void tell_of_springs(const Net& net, Account& account) {
  account.used("springs", fmt::format("{}, {} springs", net.topology, net.springs.size()));
}

void join(const Connection& connection, const Options& problem, LaidNodes& nodes, Account& account) {
  const Options springs = problem.table("springs");
  if (!connection.layout.empty())
    return at(problem.table("points").values().source, [&] { connection.make(springs, nodes, account); });
  nodes.net.grid = {};  // joined otherwise it is none
  try {
    connection.make(springs, nodes, account);
  } catch (const Refusal& refusal) {
    const Source& source = springs.has("topology") ? springs.at("topology").source : springs.values().source;
    throw InputError(source, fmt::format("topology '{}': {}", connection.name, refusal.what()));
  }
}

StudyNet read_own_springs(const Options& problem, const ProblemContext& context, Net net, Account& account) {
  const Options springs = problem.table("springs");
  TableOptions options = read_table_options(springs);
  options.scale = read_table_options(problem.table("points")).scale;  // lengths are in the nodes' unit
  SpringFile file = read_spring_file(context.files, context.files.path(springs.text("file")), net, account, options);
  net.topology = fmt::format("from {}", springs.text("file"));
  net.grid = {};
  net.springs = std::move(file.springs);
  tell_of_springs(net, account);
  account.left_out(kTriangulationStage, fmt::format("the springs are made otherwise: {}", net.topology));
  return {std::move(net), std::move(file.stiffness), std::move(file.groups), file.bounds};
}

}  // namespace

StudyNet read_net(const Options& problem, const ProblemContext& context, const Body& body, Account& account) {
  const Options springs = problem.table("springs");
  refuse_both(springs, "file", "topology");
  refuse_both(springs, "file", "nearest");
  const Layout& layout = read_layout(problem, body);
  if (springs.has("file")) {
    if (body.box) throw InputError(springs.at("file").source, "springs of a file are read in the plane only");
    // They join the nodes that a grid has.
    LaidNodes nodes = lay_nodes(layout, {problem, context, body, account, true});
    return read_own_springs(problem, context, std::move(nodes.net), account);
  }
  if (springs.has("columns"))
    throw InputError(springs.at("columns").source, "'columns' belongs to a 'file' of springs");
  const Connection& connection = read_connection(springs, layout, body.box.has_value());
  if (springs.has("nearest") && &connection != &kNearestConnection)
    throw InputError(springs.at("nearest").source, fmt::format("'nearest' belongs to topology 'nearest', and this one "
                                                               "is '{}'",
                                                               connection.name));
  const bool neighbours = !connection.layout.empty();
  LaidNodes nodes = lay_nodes(layout, {problem, context, body, account, neighbours});
  join(connection, problem, nodes, account);
  tell_of_springs(nodes.net, account);
  account.left_out(kTriangulationStage, neighbours
                                            ? "the grid's topology says which nodes are joined"
                                            : fmt::format("the springs are made otherwise: {}", nodes.net.topology));
  return {std::move(nodes.net), {}, {}};
}

}  // namespace nodal::elastic
