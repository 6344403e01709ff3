// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A chart of lines as plain figures, whatever they are of: errors over time, shares of trials over cost. It is told
/// without a script in two ways, as an SVG picture (svg_chart.h) and as a table of its figures (figures_table.h).

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nodal::report {

/// More than a picture can show.
inline constexpr std::size_t kMostChartPoints = 40;

/// What lies beyond was never measured, and powers of it overflow on the way to an axis.
inline constexpr double kLargestDrawn = 1e100;

enum class Scale { linear, logarithmic };

struct ChartAxis {
  std::string title;
  Scale scale = Scale::logarithmic;
  bool seconds = false;                                  ///< its ticks are times: "2 ms"
  std::optional<std::array<double, 2>> limits = {};      ///< else as wide as the lines, with a little room
  std::optional<std::array<double, 2>> clamped_to = {};  ///< figures beyond are drawn, and told, at these
};

/// lower and upper are y where nothing is known of the spread; an upper of +∞ is a band without an upper end.
struct ChartPoint {
  double x = 0.0, y = 0.0, lower = 0.0, upper = 0.0;
};

struct ChartLine {
  std::string label;
  std::size_t style = 0;  ///< by line_styles.h; of the baseline it doesn't count
  bool baseline = false;
  bool steps = false;                   ///< holds its height until the next point: shares of trials do
  bool band = false;                    ///< lower and upper are drawn
  bool thin = false;                    ///< one of many
  std::vector<ChartPoint> points = {};  ///< x ascending
};

/// A dashed line across, with its words below it.
struct ChartRule {
  double y = 0.0;
  std::string text;
};

struct LineChart {
  std::string title;        ///< one line: what is drawn
  std::string description;  ///< for those who don't see it: what it shows
  ChartAxis x, y;
  std::vector<ChartLine> lines;
  std::optional<ChartRule> rule = {};
  std::array<double, 2> size = {860.0, 440.0};  ///< of the picture; higher where names need it
  bool named = true;                            ///< lines have their names beside the plot
};

/// The chart as it can be drawn: without points that an axis has no place for (no numbers; on a logarithmic axis zeros)
/// and without lines that have none left, figures clamped, limits set.
[[nodiscard]] LineChart drawable(LineChart chart);

/// At most kMostChartPoints of a drawable line, the first and the last always: every so many of them; of one of steps
/// the last before each of as many places evenly along the axis, where it is as high as the whole line then.
[[nodiscard]] std::vector<ChartPoint> thinned(const ChartLine& line, const ChartAxis& across);

/// The height of a line at x: of the last point before it where the line is one of steps, or x is beyond its end; else
/// between two points, straight as it is drawn. Empty before its first point.
[[nodiscard]] std::optional<ChartPoint> point_at(const ChartLine& line, double x, const ChartAxis& across,
                                                 const ChartAxis& up);

}  // namespace nodal::report
