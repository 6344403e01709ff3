// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_net.h"

#include <fmt/format.h>

#include <nodal/error.h>

#include "import/named_file.h"
#include "import/system_files.h"
#include "read/memory_need.h"
#include "read/read_points.h"
#include "read/read_topology.h"

namespace nodal::elastic {

namespace {

LaidNodes lay_nodes(const Layout& layout, const LayoutRequest& request) {
  const Source source = request.problem.table("points").values().source;
  LaidNodes nodes = at(source, [&] { return layout.make(request); });
  // Before they are joined, which takes its time: what is too large under one group of supports is so under any.
  require_memory(nodes.net.nodes.size(), std::nullopt, available_memory(), source, nodes.net.dimension);
  request.account.left_out(kVoronoiStage, "no points were spread by them");
  return nodes;
}

void tell_of_springs(const Net& net, Account& account) {
  account.used("springs", fmt::format("{}, {} springs", net.topology, net.springs.size()));
}

void join(const Connection& connection, const Options& problem, LaidNodes& nodes, Account& account) {
  const Options springs = problem.table("springs");
  nodes.net.topology = connection.name;
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
  SpringFile file =
      read_spring_file(context.files, named_file(context.files, springs.at("file")), net, account, options);
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
  refuse_connection_options(springs);
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
