// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bounds of stiffnesses: those that a study has by default, and when a start is outside.

#include <array>

namespace nodal::elastic {

/// Times young × thickness, or times a mean of the stiffnesses themselves.
inline constexpr std::array<double, 2> kDefaultBounds = {1e-4, 1e2};

/// Whether ln k is within [ln lower, ln upper]; nearer to a bound than 1e-12 it is at it: what decimal digits, exp and
/// ln leave of a bound.
[[nodiscard]] inline bool within_bounds(double x, double lower, double upper) {
  constexpr double kAtBound = 1e-12;
  return lower - kAtBound <= x && x <= upper + kAtBound;
}

}  // namespace nodal::elastic
