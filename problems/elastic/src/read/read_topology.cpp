// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_topology.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "tables/exclusive_keys.h"
#include "tables/own_options.h"

namespace nodal::elastic {

namespace {

// "crossed for grid; triangular for triangular; delaunay for random, voronoi, file"
std::string suiting() {
  std::vector<std::string> told;
  for (const Connection* connection : connections()) {
    std::vector<std::string_view> suited;
    for (const Layout* layout : layouts())
      if (layout->connection == connection->name) suited.push_back(layout->name);
    if (!suited.empty()) told.push_back(fmt::format("{} for {}", connection->name, fmt::join(suited, ", ")));
  }
  return fmt::format("by the layout: {}", fmt::join(told, "; "));
}

std::string told_of(const Connection& connection) {
  std::vector<std::string> remarks;
  if (const std::string_view where = connection.where(); !where.empty()) remarks.emplace_back(where);
  if (connection.mechanism) remarks.emplace_back("a mechanism: refused");
  if (!connection.needs.empty()) remarks.push_back(fmt::format("needs {}", connection.needs));
  const std::string in_brackets = remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, ", "));
  return std::string(connection.name) + in_brackets;
}

// Those that join the nodes of one layout; of any, for an empty name.
std::vector<std::string> all_told_of(std::string_view layout) {
  std::vector<std::string> told;
  for (const Connection* connection : connections())
    if (connection->layout == layout) told.push_back(told_of(*connection));
  return told;
}

std::string topology_help() {
  std::string help = "which nodes are joined: ";
  for (const Layout* layout : layouts())
    if (const auto told = all_told_of(layout->name); !told.empty())
      help += fmt::format("of layout {}: {}; ", layout->name, fmt::join(told, ", "));
  return help + fmt::format("of any nodes: {}; 'nodal list topologies' says how", fmt::join(all_told_of(""), ", "));
}

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

// The one that suits the layout, and others made for it.
std::string advice(const Layout& layout, bool in_space) {
  std::vector<std::string> others;
  for (const Connection* other : connections())
    if (other->layout == layout.name && other->name != layout.connection && !other->mechanism &&
        other->is_for(in_space))
      others.push_back(fmt::format("\"{}\"", other->name));
  return fmt::format("take springs = {{ topology = \"{}\" }}{}{}", layout.connection, others.empty() ? "" : ", or ",
                     fmt::join(others, " or "));
}

void refuse_connection(const Connection& connection, const Source& source, const Layout& layout, bool in_space) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(source, fmt::format("topology '{}' {}; {}", connection.name, what, advice(layout, in_space)));
  };
  if (connection.mechanism) refuse(fmt::format("is a mechanism: {}", connection.summary));
  if (!connection.is_for(in_space)) refuse(in_space ? "is none in space" : "is none in the plane");
  if (const std::string lacks = connection.lacking(); !lacks.empty())
    throw InputError(source, fmt::format("topology '{}' needs {}", connection.name, lacks));
  if (!connection.layout.empty() && connection.layout != layout.name)
    refuse(fmt::format("doesn't join points of layout '{}'", layout.name));
}

}  // namespace

OptionSchema topology_options() {
  OptionSchema options = {
      {.name = "topology", .type = OptionType::text, .default_text = suiting(), .help = topology_help()}};
  std::ranges::move(options_of(connections()), std::back_inserter(options));
  return options;
}

const Connection& read_connection(const Options& springs, const Layout& layout, bool in_space) {
  const Connection* connection = nullptr;
  if (springs.has("topology")) {
    const std::string& topology = springs.text("topology");
    const Source& source = springs.at("topology").source;
    connection = find_named(connections(), topology);
    if (!connection)
      throw InputError(source, fmt::format("unknown topology '{}'{}", shown(topology),
                                           name_hint(topology, names_of(connections()))));
    refuse_connection(*connection, source, layout, in_space);
  } else {
    connection = &connection_of(layout, springs);
  }
  refuse_foreign_options(springs, connections(), *connection, "topology");
  return *connection;
}

void refuse_connection_options(const Options& springs) {
  for (const Option& option : topology_options()) refuse_both(springs, "file", option.name.c_str());
}

}  // namespace nodal::elastic
