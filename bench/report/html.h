// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The parts that a page is put together from, and how text gets into it safely.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plate.h"
#include "report_data.h"

namespace nodal::report {

/// Text for element content and quoted attributes.
[[nodiscard]] std::string escape_html(std::string_view text);
/// JSON for a <script> element: no "<" is left in it, so nothing in it can end the element.
[[nodiscard]] std::string escape_script(std::string json);

/// The table of one problem, in a box that scrolls by itself.
[[nodiscard]] std::string table_html(const ProblemReport& problem);
/// The chart of one problem: its data as JSON, and the empty element that report.js draws into. Empty without curves.
[[nodiscard]] std::string chart_html(const ProblemReport& problem, std::size_t index);
/// Before and after, load by load, on one scale of deformation and of colour. Empty without plates.
[[nodiscard]] std::string plates_html(std::span<const Plate> plates);

/// How even the points became, with a chart that voronoi.js draws, and how well the masses move like the body. Empty
/// where the problem says neither.
[[nodiscard]] std::string details_html(const SystemDetails& details);

/// Files that the build has put into the program. Pictures need picture_css wherever they stand; charts_js comes before
/// the other two scripts.
[[nodiscard]] std::string_view picture_css();
[[nodiscard]] std::string_view report_css();
[[nodiscard]] std::string_view charts_js();
[[nodiscard]] std::string_view report_js();
[[nodiscard]] std::string_view voronoi_js();
[[nodiscard]] std::string_view vega_js();

}  // namespace nodal::report
