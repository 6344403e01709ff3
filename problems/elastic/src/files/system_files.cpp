// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/system_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/value.h>

#include "files/csv.h"
#include "files/node_names.h"

namespace nodal::elastic {

namespace {

// A line of either kind of file.
struct NodeEntry {
  Source source;
  std::optional<std::int64_t> id;
  Point at = {0.0, 0.0};
  std::optional<double> mass;
};

struct SpringEntry {
  Source source;
  std::int64_t first = 0, second = 0;
  std::optional<double> stiffness;
  std::string group;
};

bool is_json(const std::filesystem::path& path) { return path.extension() == ".json"; }

// The list under a key of a system file.
Value::List json_list(const std::filesystem::path& path, const std::string& key, const std::string& what) {
  const Value file = parse_json(read_file(path, what + " file"), path.string());
  const Value* list = file.is_table() ? file.find(key) : nullptr;
  if (!list || !list->is_list())
    throw InputError({path.string(), 0}, fmt::format("a system file must have a list \"{}\"", key));
  return list->list();
}

// A number of a table, nothing when it isn't there.
std::optional<double> json_number(const Value& item, const char* key) {
  const Value* value = item.is_table() ? item.find(key) : nullptr;
  if (!value) return std::nullopt;
  if (!value->is_number()) throw InputError(item.source, fmt::format("\"{}\" must be a number", key));
  return value->number();
}

NodeEntry json_node(const Value& item) {
  NodeEntry entry{item.source, std::nullopt, {}, json_number(item, "mass")};
  const std::optional<double> x = json_number(item, "x"), y = json_number(item, "y");
  if (!x || !y)
    throw InputError(item.source, "a node must be {\"x\": x, \"y\": y}, with \"node\" and \"mass\" if known");
  entry.at = {*x, *y};
  if (const Value* id = item.find("node")) {
    if (!id->is_integer()) throw InputError(item.source, "\"node\" must be an integer");
    entry.id = id->integer();
  }
  return entry;
}

SpringEntry json_spring(const Value& item) {
  const Value* nodes = item.is_table() ? item.find("nodes") : nullptr;
  const bool pair = nodes && nodes->is_list() && nodes->list().size() == 2 && nodes->list()[0].is_integer() &&
                    nodes->list()[1].is_integer();
  if (!pair) throw InputError(item.source, "a spring must be {\"nodes\": [i, j]}, with \"stiffness\" if known");
  return {item.source, nodes->list()[0].integer(), nodes->list()[1].integer(), json_number(item, "stiffness"), {}};
}

std::vector<NodeEntry> node_entries(const std::filesystem::path& path) {
  std::vector<NodeEntry> entries;
  if (is_json(path)) {
    for (const Value& item : json_list(path, "nodes", "node")) entries.push_back(json_node(item));
    return entries;
  }
  const CsvTable table(read_file(path, "node file"), path.string(),
                       {{"node"}, {"x", true}, {"y", true}, {"mass"}});
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CsvRow row = table.row(i);
    NodeEntry entry{
        row.source(), std::nullopt, {row.required_number("x"), row.required_number("y")}, row.number("mass")};
    if (table.has("node")) entry.id = row.required_integer("node");
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<SpringEntry> spring_entries(const std::filesystem::path& path) {
  std::vector<SpringEntry> entries;
  if (is_json(path)) {
    for (const Value& item : json_list(path, "springs", "spring")) entries.push_back(json_spring(item));
    return entries;
  }
  const CsvTable table(read_file(path, "spring file"), path.string(),
                       {{"first", true}, {"second", true}, {"stiffness"}, {"group"}});
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CsvRow row = table.row(i);
    entries.push_back({row.source(), row.required_integer("first"), row.required_integer("second"),
                       row.number("stiffness"), row.text("group")});
    if (table.has("group") && entries.back().group.empty())
      throw InputError(row.source(), "'group' is empty; every spring must have one when the column is there");
  }
  return entries;
}

// Values that must stand in every entry or in none.
template <class Entry>
std::vector<double> all_or_none(const std::vector<Entry>& entries, std::optional<double> Entry::*value,
                                const char* name, bool zero_allowed) {
  std::vector<double> values;
  for (const Entry& entry : entries) {
    if (!(entry.*value)) {
      if (!values.empty() || std::ranges::any_of(entries, [&](const Entry& e) { return (e.*value).has_value(); }))
        throw InputError(entry.source, fmt::format("the {0} is missing; give it everywhere or nowhere", name));
      return {};
    }
    const double number = *(entry.*value);
    if (!(number > 0.0 || (zero_allowed && number == 0.0)) || !std::isfinite(number))
      throw InputError(entry.source,
                       fmt::format("the {} is {}; it must be a number {} 0", name, number, zero_allowed ? "≥" : ">"));
    values.push_back(number);
  }
  return values;
}

// Two nodes at one place have no direction between them; nearer than this share of the size is the same place.
void refuse_coincident(const std::vector<NodeEntry>& entries, double size,
                       const std::function<std::string(std::size_t)>& name) {
  constexpr double kSamePlace = 1e-12;
  std::vector<std::size_t> order(entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return entries[i].at; });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const Point &p = entries[order[a]].at, &q = entries[order[b]].at;
      if (q[0] - p[0] > kSamePlace * size) break;
      if (std::abs(q[1] - p[1]) > kSamePlace * size) continue;
      const std::size_t later = std::max(order[a], order[b]), earlier = std::min(order[a], order[b]);
      throw InputError(entries[later].source, fmt::format("node {} lies at the place of node {}: ({}, {})", name(later),
                                                          name(earlier), p[0], p[1]));
    }
}

}  // namespace

void read_node_file(const std::filesystem::path& path, Net& net) {
  const std::vector<NodeEntry> entries = node_entries(path);
  if (entries.size() < 2) throw InputError({path.string(), 0}, "a system needs at least 2 nodes");
  const bool named = entries[0].id.has_value();
  std::map<std::int64_t, std::size_t> known;
  for (const NodeEntry& entry : entries) {
    if (entry.id.has_value() != named)
      throw InputError(entry.source,
                       "some nodes have a name (\"node\") and others don't; give it everywhere or nowhere");
    if (!std::isfinite(entry.at[0]) || !std::isfinite(entry.at[1]))
      throw InputError(entry.source, "the position is not finite");
    if (named && !known.emplace(*entry.id, net.nodes.size()).second)
      throw InputError(entry.source, fmt::format("node {} stands twice", *entry.id));
    if (named) net.ids.push_back(*entry.id);
    net.nodes.push_back(entry.at);
  }
  refuse_coincident(entries, bounding_box(net.nodes).size(), [&](std::size_t i) { return std::to_string(net.id(i)); });
  net.masses = all_or_none(entries, &NodeEntry::mass, "mass", true);
  net.layout = fmt::format("{} nodes from {}", net.nodes.size(), path.filename().string());
}

SpringFile read_spring_file(const std::filesystem::path& path, const Net& net) {
  const std::vector<SpringEntry> entries = spring_entries(path);
  if (entries.empty()) throw InputError({path.string(), 0}, "the file has no springs");
  const NodeNames names(net);
  std::map<std::pair<std::size_t, std::size_t>, Source> seen;
  SpringFile file;
  for (const SpringEntry& entry : entries) {
    const std::size_t i = names.find(entry.first, entry.source), j = names.find(entry.second, entry.source);
    if (i == j) throw InputError(entry.source, fmt::format("the spring joins node {} to itself", entry.first));
    const auto [earlier, fresh] = seen.emplace(std::minmax(i, j), entry.source);
    if (!fresh)
      throw InputError(entry.source, fmt::format("spring ({}, {}) stands twice; the other one: {}", entry.first,
                                                 entry.second, earlier->second.text()));
    file.springs.push_back(make_spring(net.nodes, i, j));
    if (!entry.group.empty()) file.groups.push_back(entry.group);
  }
  file.stiffness = all_or_none(entries, &SpringEntry::stiffness, "stiffness", false);
  return file;
}

}  // namespace nodal::elastic
