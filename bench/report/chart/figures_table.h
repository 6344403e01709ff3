// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a chart shows as a table, for those who don't see it, or want figures.

#include <string>

#include "line_chart.h"

namespace nodal::report {

/// A row per line, a column per round place on the horizontal axis: the height there, and below it the band. A dash
/// before a line's first point, and for a band's end that isn't there.
[[nodiscard]] std::string figures_table(const LineChart& chart);

}  // namespace nodal::report
