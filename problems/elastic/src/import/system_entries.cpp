// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/system_entries.h"

#include <fmt/format.h>

#include <nodal/file.h>

#include "import/system_json.h"

namespace nodal::elastic {

namespace {

bool is_json(const std::filesystem::path& path) { return extension_of(path) == ".json"; }

SystemJson read_system_json(InputFiles& files, const std::filesystem::path& path, const char* what,
                            const TableOptions& options) {
  if (!options.columns.names.empty())
    throw InputError(options.columns.source, "'columns' belongs to a CSV file, and this one is JSON");
  return parse_system_json(files.read(path, what), path.string());
}

[[noreturn]] void refuse_without(const std::filesystem::path& path, const char* key) {
  throw InputError({path.string(), 0}, fmt::format("a system file must have a list \"{}\"", key));
}

}  // namespace

Entries<NodeEntry> read_node_entries(InputFiles& files, const std::filesystem::path& path,
                                     const TableOptions& options) {
  Entries<NodeEntry> entries;
  if (is_json(path)) {
    SystemJson system = read_system_json(files, path, "node file", options);
    if (!system.has_nodes) refuse_without(path, "nodes");
    entries.list = std::move(system.nodes);
    return entries;
  }
  const CsvTable table(files.read(path, "node file"), path.string(),
                       {{"node"}, {"x", true}, {"y", true}, {"z"}, {"mass"}}, options.columns);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CsvRow row = table.row(i);
    const plane::Point at = {row.required_number("x"), row.required_number("y")};
    NodeEntry entry{row.source(), std::nullopt, at, row.number("z"), row.number("mass")};
    if (table.has("node")) entry.id = row.required_integer("node");
    entries.list.push_back(std::move(entry));
  }
  entries.left_out = table.left_out();
  return entries;
}

Entries<SpringEntry> read_spring_entries(InputFiles& files, const std::filesystem::path& path,
                                         const TableOptions& options) {
  Entries<SpringEntry> entries;
  if (is_json(path)) {
    SystemJson system = read_system_json(files, path, "spring file", options);
    if (!system.has_springs) refuse_without(path, "springs");
    entries.list = std::move(system.springs);
    entries.bounds = system.bounds;
    return entries;
  }
  const CsvTable table(files.read(path, "spring file"), path.string(),
                       {{"first", true}, {"second", true}, {"stiffness"}, {"length"}, {"group"}}, options.columns);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CsvRow row = table.row(i);
    entries.list.push_back({row.source(), row.required_integer("first"), row.required_integer("second"),
                            row.number("stiffness"), row.number("length"), row.text("group")});
    if (table.has("group") && entries.list.back().group.empty())
      throw InputError(row.source(), "'group' is empty; every spring must have one when the column is there");
  }
  entries.left_out = table.left_out();
  return entries;
}

}  // namespace nodal::elastic
