// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>
#include <nodal/shown.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/same_length.h"
#include "import/system_json.h"

namespace nodal::elastic {

namespace {

std::string name_of(const std::pair<std::int64_t, std::int64_t>& nodes) {
  return fmt::format("spring ({}, {})", nodes.first, nodes.second);
}

double stiffness_of(const SpringEntry& entry, const std::string& name) {
  if (!entry.stiffness) throw InputError(entry.source, name + " has no \"stiffness\"");
  if (!(*entry.stiffness > 0.0) || !std::isnormal(*entry.stiffness))
    throw InputError(entry.source,
                     fmt::format("{} has stiffness {}; it must be a positive number", name, *entry.stiffness));
  return *entry.stiffness;
}

constexpr const char* kOtherBody =
    "the file is of another body or net, or not in metres; give stiffnesses that belong to this one";

// Springs of another body have the same names where its nodes are counted as ours are.
void require_same_length(const SpringEntry& entry, const Spring& spring, double size, const std::string& name) {
  if (entry.length && !same_length(*entry.length, spring.length, size))
    throw InputError(entry.source, fmt::format("{} has length {} m in the file and {:.6g} m in the net: {}", name,
                                               *entry.length, spring.length, kOtherBody));
}

// Nodes without a name are counted; where the net's have names these are none of theirs.
std::optional<std::int64_t> name_of(const NodeEntry& entry, std::size_t counted, const Net& net) {
  if (entry.id || !net.ids.empty()) return entry.id;
  return static_cast<std::int64_t>(counted);
}

void require_same_places(const std::vector<NodeEntry>& nodes, const Net& net, double size) {
  std::map<std::int64_t, std::size_t> index;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) index[net.id(i)] = i;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const NodeEntry& entry = nodes[i];
    const std::optional<std::int64_t> name = name_of(entry, i, net);
    if (!name) continue;
    const auto found = index.find(*name);
    if (found == index.end())
      throw InputError(entry.source, fmt::format("node {} is unknown to the net: {}", *name, kOtherBody));
    const Vector& at = net.nodes[found->second];
    const bool space = net.dimension == 3;
    const Vector said = {entry.at[0], entry.at[1], space ? entry.z.value_or(at[2]) : 0.0};
    if (same_length(said[0], at[0], size) && same_length(said[1], at[1], size) && same_length(said[2], at[2], size))
      continue;
    const auto text = [&](const Vector& v) {
      return fmt::format("({:.6g})", fmt::join(v.begin(), v.begin() + (space ? 3 : 2), ", "));
    };
    throw InputError(entry.source, fmt::format("node {} is at {} m in the file and at {} m in the net: {}", *name,
                                               text(said), text(at), kOtherBody));
  }
}

// A system with fewer springs than the study's net, as --prune leaves it, is a net of its own.
std::string whole_system_advice(const Net& net, const std::filesystem::path& path) {
  if (net.dimension == 3) return "; a system of its own, as after --prune, is read in the plane only";
  const std::string name = shown(path.filename().string());
  return fmt::format(
      "; a system of its own, as after --prune, is read by points = {{ file = \"{}\" }}, springs = {{ file = \"{}\" }}",
      name, name);
}

}  // namespace

std::vector<double> read_stiffness_file(InputFiles& files, const std::filesystem::path& path, const Net& net) {
  const SystemJson file = parse_system_json(files.read(path, "stiffness file"), path.string());
  if (!file.has_springs)
    throw InputError({path.string(), 0},
                     "a stiffness file must be {\"springs\": [{\"nodes\": [i, j], \"stiffness\": k}, …]}");

  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> index;
  for (std::size_t e = 0; e < net.springs.size(); ++e)
    index[std::minmax({net.id(net.springs[e].first), net.id(net.springs[e].second)})] = e;
  std::vector<double> stiffness(net.springs.size(), 0.0);
  const double size = extent_of(net.nodes).size();
  std::vector<bool> seen(net.springs.size(), false);
  for (const SpringEntry& entry : file.springs) {
    const std::pair<std::int64_t, std::int64_t> nodes = std::minmax({entry.first, entry.second});
    const std::string name = name_of(nodes);
    const auto found = index.find(nodes);
    if (found == index.end())
      throw InputError(entry.source, name + " is unknown: the net has no spring between these nodes");
    if (seen[found->second]) throw InputError(entry.source, name + " stands twice; every spring must stand once");
    seen[found->second] = true;
    require_same_length(entry, net.springs[found->second], size, name);
    stiffness[found->second] = stiffness_of(entry, name);
  }
  for (std::size_t e = 0; e < net.springs.size(); ++e)
    if (!seen[e])
      throw InputError({path.string(), 0},
                       fmt::format("spring ({}, {}) is missing; every spring of the net must stand once{}",
                                   net.id(net.springs[e].first), net.id(net.springs[e].second),
                                   file.has_nodes ? whole_system_advice(net, path) : ""));
  require_same_places(file.nodes, net, size);
  return stiffness;
}

std::vector<double> read_stiffness_file(const std::filesystem::path& path, const Net& net) {
  InputFiles files;
  return read_stiffness_file(files, path, net);
}

}  // namespace nodal::elastic
