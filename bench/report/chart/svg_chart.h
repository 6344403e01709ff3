// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A chart of lines as one <svg> element that needs no script.
///
/// Each line has its colour, its dashes and, right of the plot, its name. A line that ends early goes on thin and
/// dotted to its name. Colours stand in the picture, so it can be a file of its own; the style sheet of a page
/// overrules them (line_styles.h, report.css), where the page is dark, say.

#include <string>
#include <string_view>

#include "line_chart.h"

namespace nodal::report {

/// For a page. `id` is the page's only one: the picture's title and description are found by it.
[[nodiscard]] std::string svg_chart(const LineChart& chart, std::string_view id);
/// The same as a file.
[[nodiscard]] std::string svg_chart_file(const LineChart& chart);

}  // namespace nodal::report
