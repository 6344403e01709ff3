// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Places as people write them: with so many digits, and so beside the outline that they mean.
///
/// Units    metres.

#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// How far from its true place a point may be that was rounded to the digits which these have: √½ of a unit in the last
/// place. The last place is the largest coordinate's, of as many significant digits as the longest coordinate has (15
/// at most). 0 without points.
[[nodiscard]] double rounding_of(const std::vector<plane::Point>& points);

/// A node nearer to the outline than this share of the body's size, but not on it, is probably meant to be on it.
inline constexpr double kNearOutline = 1e-3;

/// The nodes that are near the outline, but not on it; `kinds` must be known. Ascending.
///
/// Cost     (nodes + sides) log sides.
[[nodiscard]] std::vector<std::size_t> nodes_beside_outline(const Net& net);

/// The share of its size within which nodes of a file are on a body's outline where a study doesn't say: kOnOutline, or
/// the nodes' rounding where that is more, up to ten times kOnOutline.
[[nodiscard]] double on_outline_as_written(const std::vector<plane::Point>& nodes, const Body& body);

}  // namespace nodal::elastic
