// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "parameters/spring_classes.h"
#include "parameters/symmetry.h"

namespace nodal::elastic {

namespace {

// A group per spring, and a name per group, in any order and of any numbers.
struct Tied {
  std::vector<std::size_t> group;
  std::vector<std::string> name;
};

std::string spring_name(const Spring& s) {
  return "k(" + std::to_string(s.first) + "," + std::to_string(s.second) + ")";
}

Tied each_alone(const Net& net) {
  Tied tied;
  for (const Spring& s : net.springs) {
    tied.group.push_back(tied.name.size());
    tied.name.push_back(spring_name(s));
  }
  return tied;
}

// By what a spring goes along: an axis, across a face, through a cell.
Tied by_block_direction(const Net& net) {
  const std::vector<std::string> names = {"k along x", "k along y", "k along z", "k face diagonal", "k body diagonal"};
  std::vector<std::size_t> kind;
  for (const Spring& s : net.springs) {
    const auto across = static_cast<std::size_t>(std::ranges::count(s.direction, 0.0));
    const auto axis = static_cast<std::size_t>(std::ranges::find_if(s.direction, [](double d) { return d != 0.0; }) -
                                               s.direction.begin());
    kind.push_back(across == 2 ? axis : 4 - across);
  }
  Tied tied;  // those that there are, in this order
  std::vector<std::size_t> number(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    number[k] = tied.name.size();
    if (std::ranges::find(kind, k) != kind.end()) tied.name.push_back(names[k]);
  }
  for (const std::size_t k : kind) tied.group.push_back(number[k]);
  return tied;
}

Tied by_grid_direction(const Net& net) {
  if (net.dimension == 3) return by_block_direction(net);
  Tied tied{{}, {"k horizontal", "k vertical", "k diagonal"}};
  for (const Spring& s : net.springs) tied.group.push_back(s.direction[1] == 0.0 ? 0 : s.direction[0] == 0.0 ? 1 : 2);
  return tied;
}

Tied by_class(SpringClasses classes) {
  for (std::string& name : classes.names) name = "k " + name;
  return {std::move(classes.of), std::move(classes.names)};
}

// A group is numbered and named by its lowest spring.
Tied symmetric(const Net& net) {
  const Symmetry symmetry = find_symmetry(net.dimension, net.nodes, net.springs);
  if (symmetry.order() == 1)
    throw Refusal(
        fmt::format("the '{}' net of {} nodes has no symmetry: no rotation or reflection about the "
                    "middle of its nodes carries nodes and springs onto nodes and springs",
                    net.topology, net.nodes.size()));
  return {symmetry_classes(symmetry, net.springs.size()), each_alone(net).name};
}

Tied listed(const Net& net, const std::vector<std::string>& groups) {
  if (groups.size() != net.springs.size())
    throw Refusal(
        fmt::format("{} groups are listed for {} springs; give one per spring", groups.size(), net.springs.size()));
  Tied tied;
  std::map<std::string, std::size_t> index;
  for (std::size_t e = 0; e < groups.size(); ++e) {
    const bool alone = groups[e].empty();
    const auto [entry, fresh] = index.emplace(groups[e], tied.name.size());
    tied.group.push_back(alone || fresh ? tied.name.size() : entry->second);
    if (alone)
      tied.name.push_back(spring_name(net.springs[e]));
    else if (fresh)
      tied.name.push_back("k " + groups[e]);
  }
  return tied;
}

Tied tie(const Net& net, const ParameterRule& rule) {
  if (rule.name == "each") return each_alone(net);
  if (rule.name == "uniform") return {std::vector<std::size_t>(net.springs.size(), 0), {"k"}};
  if (rule.name == "symmetric") return symmetric(net);
  if (rule.name == "listed" || !rule.group_of_spring.empty()) return listed(net, rule.group_of_spring);
  if (rule.name == "by-direction") {
    if (!(rule.direction_tolerance >= 0.0 && rule.direction_tolerance <= 90.0))
      throw Refusal(fmt::format("a tolerance of {}° is no tolerance of directions; it must be from 0 to 90",
                                rule.direction_tolerance));
    if (net.grid.columns > 0) return by_grid_direction(net);
    return by_class(classes_by_direction(net.springs, rule.direction_tolerance));
  }
  if (rule.name == "by-length") {
    if (rule.length_classes == 0) throw Refusal("0 classes of length leave springs without one; give ≥ 1");
    return by_class(classes_by_length(net.springs, rule.length_classes));
  }
  throw Refusal("unknown rule of parameters '" + rule.name + "'");
}

}  // namespace

ParameterRule listed_rule(const Net& net, const std::vector<SpringGroup>& groups) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> by_nodes;
  for (std::size_t e = 0; e < net.springs.size(); ++e) by_nodes[{net.springs[e].first, net.springs[e].second}] = e;
  ParameterRule rule("listed");
  rule.group_of_spring.resize(net.springs.size());
  std::set<std::string> names;
  for (const SpringGroup& group : groups) {
    if (group.name.empty()) throw Refusal("a group of springs needs a name");
    if (!names.insert(group.name).second) throw Refusal("two groups are named '" + group.name + "'");
    if (group.springs.empty()) throw Refusal("group '" + shown(group.name) + "' has no springs");
    for (const auto& ends : group.springs) {
      const auto found = by_nodes.find(std::minmax(ends[0], ends[1]));
      if (found == by_nodes.end())
        throw Refusal(fmt::format("group '{}' lists ({}, {}), but no spring joins these nodes", shown(group.name),
                                  ends[0], ends[1]));
      std::string& of_spring = rule.group_of_spring[found->second];
      if (!of_spring.empty())
        throw Refusal(of_spring == group.name
                          ? fmt::format("group '{}' lists ({}, {}) twice", shown(group.name), ends[0], ends[1])
                          : fmt::format("spring ({}, {}) is in the groups '{}' and '{}'; it can be in one", ends[0],
                                        ends[1], shown(of_spring), shown(group.name)));
      of_spring = group.name;
    }
  }
  return rule;
}

ParameterRule region_rule(const Net& net, const MaterialField& material) {
  if (material.regions.empty())
    throw Refusal(
        "'by-region' ties springs by regions of material, and there are none; give material = { regions = [ … ] }");
  ParameterRule rule("listed");
  for (const Spring& s : net.springs) {
    Vector middle{};
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      middle[axis] = 0.5 * (net.nodes[s.first][axis] + net.nodes[s.second][axis]);
    rule.group_of_spring.push_back(material.name_of(material.region_at(middle)));
  }
  return rule;
}

Parameters::Limits::Limits(const StiffnessBounds::Pair& pair) : bounds(pair) {
  constexpr double kUlps = 4.0 * std::numeric_limits<double>::epsilon();
  for (std::size_t side = 0; side < 2; ++side) {
    logarithms[side] = std::log(bounds[side]);
    rounding[side] = std::isfinite(logarithms[side]) ? kUlps * std::max(1.0, std::abs(logarithms[side])) : 0.0;
  }
  between = {logarithms[0] + rounding[0], logarithms[1] - rounding[1]};
}

void Parameters::set_limits(const StiffnessBounds& bounds) {
  if (bounds.shared()) {
    limits_.emplace_back(bounds.of(0));
    return;
  }
  limits_stride_ = 1;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::span<const std::size_t> tied = springs_of(i);
    limits_.emplace_back(bounds.of(tied.front()));
    if (std::ranges::any_of(tied, [&](std::size_t e) { return bounds.of(e) != bounds.of(tied.front()); }))
      throw std::invalid_argument("springs that are tied must have the same bounds");
  }
}

Parameters::Parameters(const Net& net, const ParameterRule& rule, const StiffnessBounds& bounds) {
  // Coordinates in the order of their first springs. Rounded ranges may read the same: names are told apart by a
  // number.
  const Tied tied = elastic::tie(net, rule);
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> coordinate(std::max(tied.name.size(), net.springs.size()), kNone);
  std::map<std::string, std::size_t> uses;
  for (const std::size_t g : tied.group) {
    if (coordinate[g] == kNone) {
      coordinate[g] = names_.size();
      const std::size_t use = ++uses[tied.name[g]];
      names_.push_back("ln " + tied.name[g] + (use == 1 ? "" : fmt::format(" ({})", use)));
    }
    group_.push_back(coordinate[g]);
  }

  members_.resize(group_.size());
  std::iota(members_.begin(), members_.end(), std::size_t{0});
  std::ranges::stable_sort(members_, {}, [this](std::size_t e) { return group_[e]; });
  first_.assign(size() + 1, 0);
  for (const std::size_t g : group_) ++first_[g + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  set_limits(bounds);
}

std::span<const std::size_t> Parameters::springs_of(std::size_t coordinate) const {
  return std::span(members_).subspan(first_.at(coordinate), first_.at(coordinate + 1) - first_[coordinate]);
}

// Coordinates are "ln k chord" where springs are tied by something with a name, "ln k(1,2)" after their lowest spring
// else.
std::string Parameters::group_name(std::size_t spring) const {
  const std::string& name = names_[group_[spring]];
  constexpr std::string_view kNamed = "ln k ", kLogarithm = "ln ";
  if (name.starts_with(kNamed)) return name.substr(kNamed.size());
  return springs_of(group_[spring]).size() > 1 ? name.substr(kLogarithm.size()) : std::string();
}

std::size_t Parameters::largest_group() const noexcept {
  std::size_t largest = 0;
  for (std::size_t g = 0; g < size(); ++g) largest = std::max(largest, first_[g + 1] - first_[g]);
  return largest;
}

double Parameters::stiffness_at_bound(const Limits& limits, double x) noexcept {
  for (std::size_t side = 0; side < 2; ++side)
    if (std::abs(x - limits.logarithms[side]) <= limits.rounding[side]) return limits.bounds[side];
  return std::exp(x);
}

void Parameters::stiffness(std::span<const double> coordinates, std::span<double> stiffness) const {
  if (one_to_one()) {
    for (std::size_t e = 0; e < springs(); ++e) stiffness[e] = stiffness_at(e, coordinates[e]);
    return;
  }
  for (std::size_t g = 0; g < size(); ++g) {
    const double k = stiffness_at(g, coordinates[g]);
    for (const std::size_t e : springs_of(g)) stiffness[e] = k;
  }
}

namespace {

bool all_equal(std::span<const std::size_t> springs, std::span<const double> stiffness) {
  return std::ranges::all_of(springs, [&](std::size_t e) { return stiffness[e] == stiffness[springs.front()]; });
}

double mean_logarithm(std::span<const std::size_t> springs, std::span<const double> stiffness) {
  if (all_equal(springs, stiffness)) return std::log(stiffness[springs.front()]);
  double sum = 0.0;
  for (const std::size_t e : springs) sum += std::log(stiffness[e]);
  return sum / static_cast<double>(springs.size());
}

}  // namespace

void Parameters::coordinates(std::span<const double> stiffness, std::span<double> coordinates) const {
  for (std::size_t g = 0; g < size(); ++g) coordinates[g] = mean_logarithm(springs_of(g), stiffness);
}

void Parameters::average(std::span<double> stiffness) const {
  for (std::size_t g = 0; g < size(); ++g) {
    const std::span<const std::size_t> springs = springs_of(g);
    if (all_equal(springs, stiffness)) continue;
    const double k = std::exp(mean_logarithm(springs, stiffness));
    for (const std::size_t e : springs) stiffness[e] = k;
  }
}

void Parameters::chain(std::span<const double> stiffness, std::span<const double> by_spring,
                       std::span<double> by_coordinate) const {
  std::ranges::fill(by_coordinate, 0.0);
  for (std::size_t e = 0; e < springs(); ++e) by_coordinate[group_[e]] += stiffness[e] * by_spring[e];
}

}  // namespace nodal::elastic
