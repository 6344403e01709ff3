// SPDX-License-Identifier: GPL-3.0-or-later
#include "profiles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/number_text.h>

#include "never.h"

namespace nodal::report {

namespace {

constexpr std::array<double, 9> kFactors = {1, 1.5, 2, 3, 5, 10, 30, 100, 1000};

std::vector<std::string> names_of(std::span<const ProblemConvergence> problems) {
  std::vector<std::string> names;
  for (const ProblemConvergence& problem : problems)
    for (const ConvergenceFigures& figures : problem.optimizers)
      if (std::ranges::find(names, figures.optimizer) == names.end()) names.push_back(figures.optimizer);
  return names;
}

double expected(const ProblemConvergence& problem, const std::string& optimizer, double gap, std::size_t axis) {
  const auto found = std::ranges::find(problem.optimizers, optimizer, &ConvergenceFigures::optimizer);
  if (found == problem.optimizers.end()) return kNever;
  const auto target = std::ranges::find(found->targets, gap, &TargetFigures::gap);
  return target == found->targets.end() ? kNever : target->expected[axis].value_or(kNever);
}

// [problems × targets][optimizers]
statistics::Matrix costs_of(std::span<const ProblemConvergence> problems, const std::vector<std::string>& names,
                            std::size_t axis) {
  statistics::Matrix costs;
  for (const ProblemConvergence& problem : problems)
    for (const double gap : kTargetGaps) {
      if (std::ranges::find(problem.refused, gap) != problem.refused.end()) continue;
      std::vector<double>& row = costs.emplace_back();
      for (const std::string& name : names) row.push_back(expected(problem, name, gap, axis));
    }
  return costs;
}

// 1, 2, 5, 10, …, from about the least to the first that all are within who get there.
std::vector<double> places_of(const statistics::Matrix& costs) {
  double least = kNever, most = 0.0;
  for (const std::vector<double>& row : costs)
    for (const double cost : row)
      if (cost > 0.0 && cost < kNever) {
        least = std::min(least, cost);
        most = std::max(most, cost);
      }
  std::vector<double> places;
  if (least == kNever) return places;
  for (int decade = static_cast<int>(std::floor(std::log10(least))); places.empty() || places.back() < most; ++decade)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double place = rounded(digit * std::pow(10.0, decade), 1);
      if (2.5 * place > least && (places.empty() || places.back() < most)) places.push_back(place);
    }
  return places;
}

std::string warning_of(const std::vector<std::string>& names, const statistics::Matrix& costs) {
  const std::optional<statistics::ProfileWarning> found = statistics::unstable_order(costs, kFactors);
  if (!found) return {};
  return fmt::format(
      "Within a factor of {:g} {} stands above {} here, but below it where {} is left out: a performance profile ranks "
      "each against the best of all, so compare two by a profile of these two alone.",
      found->factor, names[found->first], names[found->second], names[found->left_out]);
}

// Of an optimizer's column of costs: each over the least of its row, or as it is.
std::vector<statistics::Step> steps_of(const statistics::Matrix& costs, std::size_t column, bool over_least) {
  std::vector<statistics::RunLength> lengths;
  for (const std::vector<double>& row : costs) {
    const double unit = over_least ? std::ranges::min(row) : 1.0, cost = row[column];
    lengths.push_back({cost < kNever ? std::optional(cost == unit ? 1.0 : cost / unit) : std::nullopt, 0.0});
  }
  return statistics::distribution(lengths);
}

std::vector<statistics::Step> reached_by(std::span<const ProblemConvergence> problems, const std::string& name,
                                         std::size_t axis) {
  std::vector<statistics::RunLength> lengths;
  for (const ProblemConvergence& problem : problems)
    for (const ConvergenceFigures& figures : problem.optimizers)
      if (figures.optimizer == name)
        lengths.insert(lengths.end(), figures.lengths[axis].begin(), figures.lengths[axis].end());
  return statistics::distribution(lengths);
}

}  // namespace

std::vector<Profiles> make_profiles(std::span<const ProblemConvergence> problems, std::span<const Axis> axes) {
  std::vector<Profiles> all;
  for (const Axis axis : axes) {
    const auto index = static_cast<std::size_t>(axis);
    Profiles profiles;
    profiles.axis = axis;
    profiles.optimizers = names_of(problems);
    const statistics::Matrix costs = costs_of(problems, profiles.optimizers, index);
    profiles.cases = costs.size();
    profiles.costs = places_of(costs);
    if (profiles.costs.empty()) continue;
    profiles.factors.assign(kFactors.begin(), kFactors.end());
    profiles.performance = statistics::performance_profile(costs, profiles.factors);
    profiles.data = statistics::data_profile(costs, profiles.costs);
    profiles.warning = warning_of(profiles.optimizers, costs);
    for (std::size_t i = 0; i < profiles.optimizers.size(); ++i) {
      profiles.data_steps.push_back(steps_of(costs, i, false));
      profiles.performance_steps.push_back(steps_of(costs, i, true));
      profiles.reached.push_back(reached_by(problems, profiles.optimizers[i], index));
    }
    all.push_back(std::move(profiles));
  }
  return all;
}

}  // namespace nodal::report
