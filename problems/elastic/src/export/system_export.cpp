// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/stiffness.h>

#include <algorithm>

#include <fmt/format.h>

#include "export/system_format.h"

namespace nodal::elastic {

namespace {

// One entry of a list on a line of its own, so that a text editor and a diff show what has changed.
template <class Write>
std::string lines(std::size_t count, Write write) {
  std::string text = "[\n";
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("  {{{}}}{}\n", write(i), i + 1 < count ? "," : "");
  return text + "]";
}

// A file has groups for all springs or for none: a spring on its own is a group of one, named by its nodes.
std::vector<std::string> every_group(const ElasticProblem& problem) {
  std::vector<std::string> groups;
  for (std::size_t e = 0; e < problem.parameters().springs(); ++e) groups.push_back(problem.parameters().group_name(e));
  if (std::ranges::all_of(groups, &std::string::empty)) return {};
  const Net& net = problem.net();
  for (std::size_t e = 0; e < groups.size(); ++e)
    if (groups[e].empty())
      groups[e] = fmt::format("({}, {})", net.id(net.springs[e].first), net.id(net.springs[e].second));
  return groups;
}

}  // namespace

std::string system_json(const Net& net, const std::vector<double>& stiffness, const SystemDetails& details) {
  const auto node = [&](std::size_t i) {
    std::string entry = fmt::format("\"node\": {}, \"x\": {}, \"y\": {}", net.id(i), net.nodes[i][0], net.nodes[i][1]);
    if (net.dimension == 3) entry += fmt::format(", \"z\": {}", net.nodes[i][2]);
    if (!net.masses.empty()) entry += fmt::format(", \"mass\": {}", net.masses[i]);
    return entry;
  };
  const auto spring = [&](std::size_t e) {
    const Spring& s = net.springs[e];
    std::string entry = fmt::format("\"nodes\": [{}, {}], \"stiffness\": {}, \"length\": {}", net.id(s.first),
                                    net.id(s.second), stiffness.at(e), s.length);
    if (!details.groups.empty()) entry += fmt::format(", \"group\": {}", to_json(Value(details.groups.at(e))));
    return entry;
  };
  std::string text = fmt::format("{{\"schema\": {},\n", kSystemSchema);
  if (details.bounds) text += fmt::format("\"bounds\": [{}, {}],\n", (*details.bounds)[0], (*details.bounds)[1]);
  text += "\"nodes\": " + lines(net.nodes.size(), node) + ",\n";
  return text + "\"springs\": " + lines(net.springs.size(), spring) + "}\n";
}

std::string system_json(const ElasticProblem& problem, const std::vector<double>& stiffness) {
  SystemDetails details;
  details.bounds = problem.scene().stiffness_bounds.envelope();
  details.groups = every_group(problem);
  return system_json(problem.net(), stiffness, details);
}

extern const SystemFormat kSystemJson = {
    .name = "system", .extension = ".json", .summary = "JSON", .write = system_json, .read = read_stiffness_file};

}  // namespace nodal::elastic
