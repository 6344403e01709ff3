// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points on a body's outline: all corners, and on every chain between two of them a number of gaps.
///
/// Every ring gets at least 3 points, so that they make a polygon.
///
/// Units    metres.

#include <cstddef>
#include <vector>

#include <nodal/random.h>

#include "points/placement.h"

namespace nodal::elastic::plane {

enum class BorderSpread {
  evenly,     ///< equal gaps along each chain; on a closed chain from arc 0
  at_random,  ///< uniformly along each chain, no two nearer than a hundredth of the chain's mean gap
};

/// The least number of points that an outline can be given: per ring its corners, at least 3.
[[nodiscard]] std::size_t least_border_points(const Outline& outline);

/// Per chain the number of gaps nearest to its length over the spacing, a side's length being measured in cells of
/// spacing[0] × spacing[1] by its direction.
[[nodiscard]] std::vector<std::size_t> border_gaps(const Outline& outline, const Point& spacing);

/// Per chain the number of gaps such that the points number `count` in all, the widest gap as narrow as possible.
/// Refusal where count < least_border_points, saying how many are needed.
[[nodiscard]] std::vector<std::size_t> border_gaps(const Outline& outline, std::size_t count);

/// The points, ring by ring along it, corners included. `random` is drawn from by BorderSpread::at_random alone.
[[nodiscard]] PlacedPoints make_border_points(const Outline& outline, const std::vector<std::size_t>& gaps,
                                              BorderSpread spread, RandomStream& random);

}  // namespace nodal::elastic::plane
