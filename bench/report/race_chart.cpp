// SPDX-License-Identifier: GPL-3.0-or-later
#include "race_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/number_text.h>

namespace nodal::report {

namespace {

constexpr double kSmallestGap = 1e-9;     // below, a gap is rounding
constexpr double kSmallestError = 1e-16;  // likewise
constexpr double kLargestHeight = 1e150;  // beyond, the room about a curve overflows
constexpr int kRuleDigits = 4;

const std::vector<OptimizerCurves>& curves_of(const ProblemReport& problem, Raced raced) {
  return raced == Raced::unseen ? problem.unseen_curves : problem.curves;
}

const std::vector<CurvePoint>& curve_of(const OptimizerCurves& curves, Axis axis) {
  return curves.by_axis[static_cast<std::size_t>(axis)];
}

// From what the curves hold to what is drawn.
struct Height {
  double offset = 0.0, factor = 1.0;
  [[nodiscard]] double of(double quality) const { return (quality - offset) * factor; }
};

Height height_of(const ProblemReport& problem, Raced raced) {
  if (raced == Raced::unseen) return {};
  if (raced == Raced::quality) return {0.0, problem.error_per_quality.value_or(1.0)};
  const double best = problem.table.reference.best_quality;
  return {best, 1.0 / (problem.table.start_quality.value_or(best + 1.0) - best)};
}

ChartLine line_of(const OptimizerCurves& curves, const ProblemReport& problem, Axis axis, const Height& height) {
  ChartLine line = line_named(problem, curves.optimizer);
  line.band = true;
  for (const CurvePoint& p : curve_of(curves, axis))
    line.points.push_back(
        {p.position, height.of(p.quality.median), height.of(p.quality.lower), height.of(p.quality.upper)});
  return line;
}

std::optional<ChartRule> best_known(const ProblemReport& problem, Raced raced, const Height& height) {
  const ProblemReference& reference = problem.table.reference;
  const double at = height.of(reference.best_quality);
  if (raced != Raced::quality || !(at > 0.0)) return std::nullopt;
  return ChartRule{at, fmt::format("{}: {}", reference.provisional ? "best of these trials" : "best known",
                                   figure_text(at, kRuleDigits))};
}

}  // namespace

std::string_view axis_name(Axis axis) noexcept {
  return axis == Axis::seconds ? "time" : axis == Axis::work ? "flops" : to_string(axis);
}

std::string_view axis_title(Axis axis) noexcept {
  return axis == Axis::work ? "flops, in those of one full evaluation" : axis_name(axis);
}

std::string height_title(const ProblemReport& problem, Raced raced) {
  if (raced == Raced::unseen) return unseen_finding().title;
  if (raced == Raced::gap) return "gap to " + problem.raced_name() + "*";
  if (problem.error_per_quality) return "relative error";
  return problem.table.has_prior ? problem.raced_name() : "quality";
}

ChartLine line_named(const ProblemReport& problem, const std::string& optimizer) {
  ChartLine line{.label = optimizer};
  for (const RowRequest& one : problem.contestants) {
    if (one.label == optimizer) {
      line.baseline = one.baseline;
      break;
    }
    line.style += one.baseline ? 0 : 1;
  }
  return line;
}

bool has_gap(const ProblemReport& problem) {
  const ProblemTable& table = problem.table;
  return table.start_quality && std::isfinite(*table.start_quality) && !table.start_is_best &&
         !table.reference.unimproved && *table.start_quality > table.reference.best_quality;
}

std::string ends_text(const LineChart& chart, bool highest_first) {
  std::vector<const ChartLine*> lines;
  for (const ChartLine& line : chart.lines)
    if (!line.points.empty()) lines.push_back(&line);
  std::ranges::stable_sort(lines, [highest_first](const ChartLine* a, const ChartLine* b) {
    const double first = a->points.back().y, second = b->points.back().y;
    return highest_first ? first > second : first < second;
  });
  std::vector<std::string> texts;
  for (const ChartLine* line : lines)
    texts.push_back(fmt::format("{} {}", line->label, figure_text(line->points.back().y, 3)));
  return fmt::format("At the end, {} first: {}.", highest_first ? "highest" : "lowest", fmt::join(texts, ", "));
}

LineChart race_chart(const ProblemReport& problem, Raced raced, Axis axis) {
  const Height height = height_of(problem, raced);
  const std::string up = height_title(problem, raced);
  LineChart chart;
  chart.title = fmt::format("{}: {} against {}", problem.table.reference.label, up, axis_name(axis));
  chart.x = {std::string(axis_title(axis)), Scale::logarithmic, axis == Axis::seconds};
  chart.y = {up, Scale::logarithmic};
  chart.y.clamped_to = {raced == Raced::gap ? kSmallestGap : kSmallestError, kLargestHeight};
  for (const OptimizerCurves& curves : curves_of(problem, raced))
    chart.lines.push_back(line_of(curves, problem, axis, height));
  chart.rule = best_known(problem, raced, height);
  chart.description = "Median over trials, with the middle half of them as a band. " + ends_text(chart, false);
  return chart;
}

}  // namespace nodal::report
