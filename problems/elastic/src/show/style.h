// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Files of this folder that the build has put into the program.

#include <string_view>

namespace nodal::elastic::show {

/// Of pictures, wherever they stand.
[[nodiscard]] std::string_view picture_css();
/// Of what stands in a page: pictures side by side, and how nets were made.
[[nodiscard]] std::string_view pictures_css();
[[nodiscard]] std::string_view details_css();
/// Draws the charts of details_html.
[[nodiscard]] std::string_view voronoi_js();
/// Tells of springs in pictures that are pointed at.
[[nodiscard]] std::string_view springs_js();

}  // namespace nodal::elastic::show
