// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/parameters.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

namespace nodal::elastic {

namespace {

std::string spring_name(const Spring& s) {
  return "k(" + std::to_string(s.first) + "," + std::to_string(s.second) + ")";
}

std::string direction_name(const Spring& s) {
  if (s.direction[1] == 0.0) return "horizontal";
  return s.direction[0] == 0.0 ? "vertical" : "diagonal";
}

// Where a reflection of the grid carries a node.
using NodeMap = std::function<std::size_t(std::size_t)>;

std::vector<NodeMap> reflections(const Net& net) {
  const std::size_t columns = net.grid.columns, rows = net.grid.rows;
  std::vector<NodeMap> maps;
  maps.push_back([=](std::size_t i) { return i / columns * columns + (columns - 1 - i % columns); });
  maps.push_back([=](std::size_t i) { return (rows - 1 - i / columns) * columns + i % columns; });
  const bool square = columns == rows && std::abs(net.grid.cell[0] - net.grid.cell[1]) <= 1e-9 * net.grid.cell[0];
  if (square) maps.push_back([=](std::size_t i) { return i % columns * columns + i / columns; });
  return maps;
}

// The lowest spring of each spring's class under the reflections.
std::vector<std::size_t> symmetry_classes(const Net& net) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> by_nodes;
  for (std::size_t e = 0; e < net.springs.size(); ++e) by_nodes[{net.springs[e].first, net.springs[e].second}] = e;
  std::vector<std::size_t> lowest(net.springs.size());
  std::iota(lowest.begin(), lowest.end(), std::size_t{0});
  const std::vector<NodeMap> maps = reflections(net);
  // Reflections commute up to the group they generate, so classes settle after as many passes as there are maps.
  for (std::size_t pass = 0; pass <= maps.size(); ++pass) {
    for (const NodeMap& map : maps) {
      for (std::size_t e = 0; e < net.springs.size(); ++e) {
        const auto image = std::minmax({map(net.springs[e].first), map(net.springs[e].second)});
        const auto found = by_nodes.find({image.first, image.second});
        if (found == by_nodes.end())
          throw std::invalid_argument("the '" + net.topology + "' topology of a " + std::to_string(net.grid.columns) +
                                      " × " + std::to_string(net.grid.rows) +
                                      " grid is not symmetric under the plate's reflections");
        lowest[e] = lowest[found->second] = std::min(lowest[e], lowest[found->second]);
      }
    }
  }
  return lowest;
}

}  // namespace

Parameters::Parameters(const Net& net, const std::string& rule) {
  std::map<std::string, std::size_t> index;
  const auto tie = [&](const std::string& name) {
    const auto [entry, fresh] = index.emplace(name, names_.size());
    if (fresh) names_.push_back("ln " + name);
    group_.push_back(entry->second);
  };
  if (rule == "each") {
    for (const Spring& s : net.springs) tie(spring_name(s));
  } else if (rule == "by-direction") {
    for (const Spring& s : net.springs) tie("k " + direction_name(s));
  } else if (rule == "uniform") {
    for (std::size_t e = 0; e < net.springs.size(); ++e) tie("k");
  } else if (rule == "symmetric") {
    for (const std::size_t lowest : symmetry_classes(net)) tie(spring_name(net.springs[lowest]));
  } else {
    throw std::invalid_argument("unknown rule of parameters '" + rule + "'");
  }

  members_.resize(group_.size());
  std::iota(members_.begin(), members_.end(), std::size_t{0});
  std::ranges::stable_sort(members_, {}, [this](std::size_t e) { return group_[e]; });
  first_.assign(size() + 1, 0);
  for (const std::size_t g : group_) ++first_[g + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::span<const std::size_t> Parameters::springs_of(std::size_t coordinate) const {
  return std::span(members_).subspan(first_.at(coordinate), first_.at(coordinate + 1) - first_[coordinate]);
}

std::size_t Parameters::largest_group() const noexcept {
  std::size_t largest = 0;
  for (std::size_t g = 0; g < size(); ++g) largest = std::max(largest, first_[g + 1] - first_[g]);
  return largest;
}

void Parameters::stiffness(std::span<const double> coordinates, std::span<double> stiffness) const {
  if (one_to_one()) {
    for (std::size_t e = 0; e < springs(); ++e) stiffness[e] = std::exp(coordinates[e]);
    return;
  }
  for (std::size_t g = 0; g < size(); ++g) {
    const double k = std::exp(coordinates[g]);
    for (const std::size_t e : springs_of(g)) stiffness[e] = k;
  }
}

void Parameters::coordinates(std::span<const double> stiffness, std::span<double> coordinates) const {
  for (std::size_t g = 0; g < size(); ++g) {
    double sum = 0.0;
    for (const std::size_t e : springs_of(g)) sum += std::log(stiffness[e]);
    coordinates[g] = sum / static_cast<double>(springs_of(g).size());
  }
}

void Parameters::chain(std::span<const double> stiffness, std::span<const double> by_spring,
                       std::span<double> by_coordinate) const {
  std::ranges::fill(by_coordinate, 0.0);
  for (std::size_t e = 0; e < springs(); ++e) by_coordinate[group_[e]] += stiffness[e] * by_spring[e];
}

}  // namespace nodal::elastic
