// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sizes that several drawings have in common, in drawing units.

namespace nodal::elastic::show {

inline constexpr double kMargin = 16.0;     ///< of a picture
inline constexpr double kGap = 16.0;        ///< between panels
inline constexpr double kBarHeight = 10.0;  ///< of a scale's colours
inline constexpr double kLabelSize = 11.0;  ///< as .label in picture.css

}  // namespace nodal::elastic::show
