// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A picture as an SVG file of its own: the system at rest, then a panel per load, to be read at 600 px. Loads that
/// were never fitted stand below the others, under a heading.
///
/// The text is XML, needs no fonts, scripts or other files, and stands on white. It is the same for the same figures on
/// every machine; numbers have one digit after the point, so figures that differ by rounding give the same text unless
/// one lies half-way between two.
/// Nets of many springs are thinned (DrawnSprings), which the picture says: a panel has at most about 25 bytes for each
/// of those drawn.

#include <array>
#include <string>
#include <vector>

#include "show/picture.h"
#include "show/picture_frame.h"

namespace nodal::elastic::show {

inline constexpr double kPictureWidth = 600.0;  ///< drawing units, and pixels unless a viewer scales it

[[nodiscard]] std::string picture_svg(const Picture& picture);

/// What lines, dots and marks mean, for what there is of them in this picture: a sentence each.
[[nodiscard]] std::vector<std::string> picture_legend(const Picture& picture, const Frame& frame);

/// k_max/k_min, four digits.
[[nodiscard]] std::string spread_text(const Picture& picture);

/// What stands over loads that were never fitted.
[[nodiscard]] std::string unseen_heading(const Picture& picture);

/// A load's name, and how wrong the system is under it: two lines.
[[nodiscard]] std::array<std::string, 2> load_caption(const PicturedLoad& load);

/// The frame of a file: declaration, title for those who don't see it, style, white ground.
[[nodiscard]] std::string svg_file(const std::string& title, double height, const std::string& content);

}  // namespace nodal::elastic::show
