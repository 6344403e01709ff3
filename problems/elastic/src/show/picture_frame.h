// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// From metres to drawing units: one scale for both axes, y up in metres and down in the drawing.

#include <vector>

#include "show/picture.h"

namespace nodal::elastic::show {

/// What all panels of a problem share, so that they compare.
struct Frame {
  Point low = {0.0, 0.0};  ///< metres, lower left of the picture
  double unit = 1.0;       ///< drawing units per metre
  double width = 0.0, height = 0.0;
  double magnification = 1.0;  ///< displacements are drawn this much larger: 1, 2 or 5 times a power of ten
  double arrow = 0.0;          ///< drawing units per newton
  double spacing = 0.0;        ///< between neighbours, on average, in drawing units: what widths and sizes follow

  [[nodiscard]] Point at(const Point& node, const Point& displacement = {0.0, 0.0}) const;
  /// Of a spring's line; the lines of a large net must be thin to be told apart.
  [[nodiscard]] double line_width() const;
};

inline constexpr double kPanelWidth = 240.0;  ///< drawing units, in the report, which scales them

/// For the deformed system under every load; never taller than 1.25 times its width.
[[nodiscard]] Frame make_frame(const std::vector<const Picture*>& pictures, double width = kPanelWidth);
/// For the system at rest, with `strip` drawing units left free below it.
[[nodiscard]] Frame make_rest_frame(const Picture& picture, double width, double strip);

/// A frame of that width around a box in metres, with margins in drawing units; at most 1.25 times as tall as wide.
[[nodiscard]] Frame fit_frame(const plane::Box& box, double width, double margin, double strip);

/// The largest of 1, 2, 5 × a power of ten that is not above `value`, which is positive.
[[nodiscard]] double round_down_125(double value);

[[nodiscard]] double length(const Point& v);
[[nodiscard]] double largest(const std::vector<Point>& vectors);

}  // namespace nodal::elastic::show
