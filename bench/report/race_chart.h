// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The race of one problem as a chart: best quality so far of each optimizer, or its unseen error, over each axis.

#include <string>
#include <vector>

#include "chart/line_chart.h"
#include "report_data.h"

namespace nodal::report {

enum class Raced {
  quality,  ///< relative error where that is the quality times a constant
  gap,      ///< to the best known: from 1 at the start to 0
  unseen    ///< error of what is held out
};

/// "time", "evaluations", "factorizations", "flops": what people choose between.
[[nodiscard]] std::string_view axis_name(Axis axis) noexcept;
/// With the unit: "flops [full evaluations]".
[[nodiscard]] std::string_view axis_title(Axis axis) noexcept;
/// Of what is raced: "relative error", "gap to G*", "unseen error".
[[nodiscard]] std::string height_title(const ProblemReport& problem, Raced raced);

/// An empty line that looks as the optimizer's do in every chart.
[[nodiscard]] ChartLine line_named(const ProblemReport& problem, const std::string& optimizer);

/// There is a gap to draw: the start was measured and isn't the best.
[[nodiscard]] bool has_gap(const ProblemReport& problem);
/// In words, for those who don't see a chart: at what height each line ends, the best first.
[[nodiscard]] std::string ends_text(const LineChart& chart, bool highest_first);
/// The chart without a script. Empty lines where there are no curves.
[[nodiscard]] LineChart race_chart(const ProblemReport& problem, Raced raced, Axis axis);
/// The same for report.js: all axes, qualities from which it makes gaps.
[[nodiscard]] Value race_data(const ProblemReport& problem, Raced raced);

}  // namespace nodal::report
