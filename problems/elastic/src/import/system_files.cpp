// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/system_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "import/node_names.h"
#include "import/same_height.h"
#include "import/same_length.h"
#include "import/system_entries.h"

namespace nodal::elastic {

namespace {

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
  constexpr double kCoincident = 1e-12;
  std::vector<std::size_t> order(entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](std::size_t i) { return entries[i].at; });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const plane::Point &p = entries[order[a]].at, &q = entries[order[b]].at;
      if (q[0] - p[0] > kCoincident * size) break;
      if (std::abs(q[1] - p[1]) > kCoincident * size) continue;
      const std::size_t later = std::max(order[a], order[b]), earlier = std::min(order[a], order[b]);
      throw InputError(entries[later].source, fmt::format("node {} lies at the place of node {}: ({}, {})", name(later),
                                                          name(earlier), p[0], p[1]));
    }
}

void refuse_too_few_groups(const std::vector<SpringEntry>& entries) {
  const auto grouped = [](const SpringEntry& entry) { return !entry.group.empty(); };
  if (std::ranges::none_of(entries, grouped)) return;
  const auto without = std::ranges::find_if_not(entries, grouped);
  if (without != entries.end())
    throw InputError(without->source, "the group is missing; give it everywhere or nowhere");
}

// Springs are at rest where their nodes are: a length of its own would be one of a stressed system.
void require_rest_length(const SpringEntry& entry, const Spring& spring, double scale, double size) {
  if (!entry.length || same_length(*entry.length * scale, spring.length, size)) return;
  throw InputError(
      entry.source,
      fmt::format("spring ({}, {}) has length {}, and its nodes are {:.6g} apart: springs at rest only can "
                  "be computed with; leave the length out if this one is",
                  entry.first, entry.second, *entry.length, spring.length / scale));
}

}  // namespace

// A block that nodal has written, say (stiffness.h).
constexpr const char* kInSpace = ". Systems in space are read as starts only";

void read_node_file(InputFiles& files, const std::filesystem::path& path, Net& net, Account& account,
                    const TableOptions& options) {
  const Entries<NodeEntry> read = read_node_entries(files, path, options);
  const std::vector<NodeEntry>& entries = read.list;
  if (entries.size() < 2) throw InputError({path.string(), 0}, "a system needs at least 2 nodes");
  const bool named = entries[0].id.has_value();
  std::map<std::int64_t, std::size_t> known;
  SameHeight heights;
  for (const NodeEntry& entry : entries) {
    if (entry.id.has_value() != named)
      throw InputError(entry.source,
                       "some nodes have a name (\"node\") and others don't; give it everywhere or nowhere");
    const plane::Point at = {entry.at[0] * options.scale, entry.at[1] * options.scale};
    if (!std::isfinite(at[0]) || !std::isfinite(at[1])) throw InputError(entry.source, "the position is not finite");
    if (named && !known.emplace(*entry.id, net.nodes.size()).second)
      throw InputError(entry.source, fmt::format("node {} stands twice", *entry.id));
    heights.add(entry.z, entry.source, kInSpace);
    if (named) net.ids.push_back(*entry.id);
    net.nodes.push_back(lifted(at));
  }
  refuse_coincident(entries, extent_of(net.nodes).size() / options.scale,
                    [&](std::size_t i) { return std::to_string(net.id(i)); });
  net.masses = all_or_none(entries, &NodeEntry::mass, "mass", true);
  std::string told = fmt::format("{} nodes from {}", net.nodes.size(), path.filename().string());
  if (options.scale != 1.0) told += fmt::format(", times {}", options.scale);
  account.used("points", std::move(told));
  for (const std::string& remark : {read.left_out, heights.left_out(path.string())})
    if (!remark.empty()) account.remark(remark);
}

SpringFile read_spring_file(InputFiles& files, const std::filesystem::path& path, const Net& net, Account& account,
                            const TableOptions& options) {
  const Entries<SpringEntry> read = read_spring_entries(files, path, options);
  const std::vector<SpringEntry>& entries = read.list;
  if (entries.empty()) throw InputError({path.string(), 0}, "the file has no springs");
  refuse_too_few_groups(entries);
  const NodeNames names(net);
  const double size = extent_of(net.nodes).size();
  std::map<std::pair<std::size_t, std::size_t>, Source> seen;
  SpringFile file;
  file.bounds = read.bounds;
  for (const SpringEntry& entry : entries) {
    const std::size_t i = names.find(entry.first, entry.source), j = names.find(entry.second, entry.source);
    if (i == j) throw InputError(entry.source, fmt::format("the spring joins node {} to itself", entry.first));
    const auto [earlier, fresh] = seen.emplace(std::minmax(i, j), entry.source);
    if (!fresh)
      throw InputError(entry.source, fmt::format("spring ({}, {}) stands twice; the other one: {}", entry.first,
                                                 entry.second, earlier->second.text()));
    file.springs.push_back(make_spring(net.nodes, i, j));
    require_rest_length(entry, file.springs.back(), options.scale, size);
    if (!entry.group.empty()) file.groups.push_back(entry.group);
  }
  file.stiffness = all_or_none(entries, &SpringEntry::stiffness, "stiffness", false);
  if (!read.left_out.empty()) account.remark(read.left_out);
  return file;
}

}  // namespace nodal::elastic
