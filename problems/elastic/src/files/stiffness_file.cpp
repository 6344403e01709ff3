// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>
#include <nodal/file.h>
#include <nodal/value.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// The entry of one spring: {"nodes": [i, j], "stiffness": k}.
struct Entry {
  std::pair<std::int64_t, std::int64_t> nodes;
  double stiffness;
};

Entry parse_entry(const Value& item) {
  const Value* nodes = item.is_table() ? item.find("nodes") : nullptr;
  const Value* stiffness = item.is_table() ? item.find("stiffness") : nullptr;
  const bool pair = nodes && nodes->is_list() && nodes->list().size() == 2 && nodes->list()[0].is_integer() &&
                    nodes->list()[1].is_integer();
  if (!pair || !stiffness || !stiffness->is_number())
    throw InputError(item.source, "a spring must be {\"nodes\": [i, j], \"stiffness\": k}");
  const std::int64_t i = nodes->list()[0].integer(), j = nodes->list()[1].integer();
  return {{std::min(i, j), std::max(i, j)}, stiffness->number()};
}

}  // namespace

std::vector<double> read_stiffness_file(const std::filesystem::path& path, const Net& net) {
  const Value file = parse_json(read_file(path, "stiffness file"), path.string());
  const Value* springs = file.is_table() ? file.find("springs") : nullptr;
  if (!springs || !springs->is_list())
    throw InputError({path.string(), 0},
                     "a stiffness file must be {\"springs\": [{\"nodes\": [i, j], \"stiffness\": k}, …]}");

  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> index;
  for (std::size_t e = 0; e < net.springs.size(); ++e)
    index[std::minmax({net.id(net.springs[e].first), net.id(net.springs[e].second)})] = e;
  std::vector<double> stiffness(net.springs.size(), 0.0);
  std::vector<bool> seen(net.springs.size(), false);
  for (const Value& item : springs->list()) {
    const Entry entry = parse_entry(item);
    const std::string name = fmt::format("spring ({}, {})", entry.nodes.first, entry.nodes.second);
    const auto found = index.find(entry.nodes);
    if (found == index.end())
      throw InputError(item.source, name + " is unknown: the net has no spring between these nodes");
    if (seen[found->second]) throw InputError(item.source, name + " stands twice; every spring must stand once");
    if (!(entry.stiffness > 0.0) || !std::isnormal(entry.stiffness))
      throw InputError(item.source,
                       fmt::format("{} has stiffness {}; it must be a positive number", name, entry.stiffness));
    seen[found->second] = true;
    stiffness[found->second] = entry.stiffness;
  }
  for (std::size_t e = 0; e < net.springs.size(); ++e)
    if (!seen[e])
      throw InputError({path.string(), 0},
                       fmt::format("spring ({}, {}) is missing; every spring of the net must stand once",
                                   net.id(net.springs[e].first), net.id(net.springs[e].second)));
  return stiffness;
}

}  // namespace nodal::elastic
