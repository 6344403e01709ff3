// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nodal::report {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

bool has_place(double value, const ChartAxis& axis) {
  return std::abs(value) <= kLargestDrawn &&
         (axis.scale == Scale::linear || axis.clamped_to || value >= 1.0 / kLargestDrawn);
}

double clamped(double value, const ChartAxis& axis) {
  return axis.clamped_to ? std::clamp(value, (*axis.clamped_to)[0], (*axis.clamped_to)[1]) : value;
}

ChartPoint clamped(const ChartPoint& p, const LineChart& chart) {
  const double upper = std::isinf(p.upper) ? p.upper : clamped(p.upper, chart.y);
  return {clamped(p.x, chart.x), clamped(p.y, chart.y), clamped(p.lower, chart.y), upper};
}

std::vector<ChartPoint> drawable_points(const std::vector<ChartPoint>& all, const LineChart& chart) {
  std::vector<ChartPoint> points;
  for (const ChartPoint& p : all)
    if (has_place(p.x, chart.x) && has_place(p.y, chart.y) && has_place(p.lower, chart.y) &&
        (has_place(p.upper, chart.y) || p.upper == kEndless))
      points.push_back(clamped(p, chart));
  return points;
}

struct Extent {
  double low = kEndless, high = -kEndless;
  void take(double value) {
    if (value == kEndless) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// A little room on both sides, in the logarithm where the axis is one.
std::array<double, 2> padded(Extent extent, Scale scale) {
  if (!(extent.low <= extent.high)) return {1.0, 10.0};
  if (scale == Scale::linear) {
    const double room = extent.high > extent.low ? 0.04 * (extent.high - extent.low) : 0.5;
    return {extent.low - room, extent.high + room};
  }
  const double room = std::max(std::pow(extent.high / extent.low, 0.04), 1.02);
  return {extent.low / room, extent.high * room};
}

void set_limits(LineChart& chart) {
  Extent across, up;
  for (const ChartLine& line : chart.lines)
    for (const ChartPoint& p : line.points) {
      across.take(p.x);
      for (const double y : {p.y, line.band ? p.lower : p.y, line.band ? p.upper : p.y}) up.take(y);
    }
  if (chart.rule) {
    // With room for its words below it, where no line goes.
    const double y = chart.rule->y, top = std::max(y, up.high);
    up.take(y);
    if (chart.y.scale == Scale::logarithmic && y > 0.0) up.take(y * std::pow(y / top, 0.05));
  }
  if (!chart.x.limits) chart.x.limits = padded(across, chart.x.scale);
  if (!chart.y.limits) chart.y.limits = padded(up, chart.y.scale);
}

double between(double a, double b, double share, Scale scale) {
  if (scale == Scale::linear || a <= 0.0 || b <= 0.0) return a + share * (b - a);
  return a * std::pow(b / a, share);
}

double share_of(double a, double b, double x, Scale scale) {
  if (!(b > a)) return 1.0;
  return scale == Scale::linear ? (x - a) / (b - a) : std::log(x / a) / std::log(b / a);
}

constexpr std::size_t kLast = kMostChartPoints - 1;

std::vector<ChartPoint> every_so_many(const std::vector<ChartPoint>& points) {
  std::vector<ChartPoint> kept;
  for (std::size_t i = 0; i <= kLast; ++i) kept.push_back(points[i * (points.size() - 1) / kLast]);
  return kept;
}

std::vector<ChartPoint> every_so_far(const std::vector<ChartPoint>& points, Scale scale) {
  std::vector<ChartPoint> kept = {points.front()};
  for (std::size_t i = 1; i < kLast; ++i) {
    const double place = between(points.front().x, points.back().x, static_cast<double>(i) / kLast, scale);
    const ChartPoint& before = *std::prev(std::ranges::upper_bound(points, place, {}, &ChartPoint::x));
    if (before.x > kept.back().x) kept.push_back(before);
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace

LineChart drawable(LineChart chart) {
  for (ChartLine& line : chart.lines) line.points = drawable_points(line.points, chart);
  std::erase_if(chart.lines, [](const ChartLine& line) { return line.points.empty(); });
  if (chart.rule && !has_place(chart.rule->y, chart.y)) chart.rule.reset();
  if (chart.rule) chart.rule->y = clamped(chart.rule->y, chart.y);
  set_limits(chart);
  return chart;
}

std::vector<ChartPoint> thinned(const ChartLine& line, const ChartAxis& across) {
  if (line.points.size() <= kMostChartPoints) return line.points;
  return line.steps ? every_so_far(line.points, across.scale) : every_so_many(line.points);
}

std::optional<ChartPoint> point_at(const ChartLine& line, double x, const ChartAxis& across, const ChartAxis& up) {
  const auto after = std::ranges::upper_bound(line.points, x, {}, [](const ChartPoint& p) { return p.x; });
  if (after == line.points.begin()) return std::nullopt;
  const ChartPoint& before = *std::prev(after);
  if (after == line.points.end() || line.steps) return ChartPoint{x, before.y, before.lower, before.upper};
  const double share = share_of(before.x, after->x, x, across.scale);
  return ChartPoint{x, between(before.y, after->y, share, up.scale),
                    between(before.lower, after->lower, share, up.scale),
                    between(before.upper, after->upper, share, up.scale)};
}

}  // namespace nodal::report
