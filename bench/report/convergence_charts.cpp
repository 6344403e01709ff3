// SPDX-License-Identifier: GPL-3.0-or-later
#include "convergence_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/statistics/anytime.h>

#include "race_chart.h"

namespace nodal::report {

namespace {

constexpr std::array<double, 2> kShares = {0.0, 1.0};
constexpr double kSmallestShown = 1e-16, kLargestShown = 1e150;  // beyond, a figure is rounding, or none

LineChart share_chart(std::string title, std::string across, bool seconds, const Profiles& profiles,
                      const std::vector<std::vector<statistics::Step>>& steps,
                      const std::vector<ProblemReport>& problems) {
  LineChart chart;
  chart.title = std::move(title);
  chart.x = {std::move(across), Scale::logarithmic, seconds};
  chart.y = {"share", Scale::linear, false, kShares};
  for (std::size_t i = 0; i < profiles.optimizers.size(); ++i) {
    const std::string& name = profiles.optimizers[i];
    ChartLine& line = chart.lines.emplace_back(problems.empty() ? ChartLine{name, i} : line_named(problems[0], name));
    line.steps = true;
    for (const statistics::Step& step : steps[i]) line.points.push_back({step.at, step.share, step.share, step.share});
  }
  chart.description = ends_text(chart, true);
  return chart;
}

// Where an optimizer's line begins and ends in the race: the start, at cost 0, has no place of its own on a logarithmic
// axis.
std::array<double, 2> ends_in_race(const ProblemReport& problem, const std::string& optimizer, Axis axis) {
  const auto raced = std::ranges::find(problem.curves, optimizer, &OptimizerCurves::optimizer);
  if (raced == problem.curves.end()) return {0.0, 0.0};
  const std::vector<CurvePoint>& curve = raced->by_axis[static_cast<std::size_t>(axis)];
  return curve.empty() ? std::array{0.0, 0.0} : std::array{curve.front().position, curve.back().position};
}

// What was attained before the race's left end stands at that end; what is attained at last lasts to the right one.
void keep_between(const std::array<double, 2>& ends, std::vector<ChartPoint>& points) {
  for (ChartPoint& point : points) point.x = std::max(point.x, ends[0]);
  const auto in_one_place = [](const ChartPoint& a, const ChartPoint& b) { return a.x == b.x; };
  points.erase(points.begin(), std::unique(points.rbegin(), points.rend(), in_one_place).base());
  if (points.empty() || points.back().x >= ends[1]) return;
  points.push_back(points.back());
  points.back().x = ends[1];
}

// Of all three shares at every cost at which one of them gets better.
std::vector<ChartPoint> attained_points(const std::vector<statistics::History>& attained, double factor) {
  std::vector<double> costs;
  for (const statistics::History& surface : attained)
    for (const statistics::BestSoFar& point : surface) costs.push_back(point.cost);
  std::ranges::sort(costs);
  costs.erase(std::unique(costs.begin(), costs.end()), costs.end());
  std::vector<ChartPoint> points;
  for (const double cost : costs) {
    const auto height = [&](std::size_t share) { return factor * statistics::quality_at(attained[share], cost); };
    if (const double half = height(1); std::isfinite(half)) points.push_back({cost, half, height(0), height(2)});
  }
  return points;
}

std::string without_line_text(const LineChart& chart) {
  std::vector<std::string> names;
  for (const ChartLine& line : chart.lines)
    if (line.points.empty()) names.push_back(line.label);
  return names.empty() ? ""
                       : fmt::format(" Without a line, because more than half of the trials have no result: {}.",
                                     fmt::join(names, ", "));
}

}  // namespace

LineChart attainment_chart(const ProblemReport& problem, const ProblemConvergence& convergence, Axis axis) {
  const double factor = problem.error_per_quality.value_or(1.0);
  const std::string up = height_title(problem, Raced::quality);
  LineChart chart;
  chart.title = fmt::format("{}: {} attained, against {}", convergence.problem, up, axis_name(axis));
  chart.x = {std::string(axis_title(axis)), Scale::logarithmic, axis == Axis::seconds};
  chart.y = {up, Scale::logarithmic};
  chart.y.clamped_to = {kSmallestShown, kLargestShown};
  for (const ConvergenceFigures& figures : convergence.optimizers) {
    ChartLine& line = chart.lines.emplace_back(line_named(problem, figures.optimizer));
    line.steps = line.band = true;
    line.points = attained_points(figures.attained[static_cast<std::size_t>(axis)], factor);
    keep_between(ends_in_race(problem, figures.optimizer, axis), line.points);
  }
  chart.description = "Attained by half of the trials, with a band from a quarter to three quarters of them. " +
                      ends_text(chart, false) + without_line_text(chart);
  return chart;
}

ProfileCharts profile_charts(const Profiles& profiles, const std::vector<ProblemReport>& problems) {
  const std::string by(axis_name(profiles.axis));
  const std::string across(axis_title(profiles.axis));
  const bool seconds = profiles.axis == Axis::seconds;
  const std::string of = fmt::format("share of {} targets of all problems", profiles.cases);
  return {share_chart(fmt::format("Data profile: {}, by their expected {}", of, by), across, seconds, profiles,
                      profiles.data_steps, problems),
          share_chart(fmt::format("Performance profile: {} within a factor of the least {}", of, by), "factor", false,
                      profiles, profiles.performance_steps, problems),
          share_chart(fmt::format("Run lengths: share of trials × targets reached, by {}", by), across, seconds,
                      profiles, profiles.reached, problems)};
}

}  // namespace nodal::report
