// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How many coordinates a box has decided, counted and in words.

#include <cstddef>
#include <span>
#include <string>

#include <nodal/space.h>

namespace nodal {

struct AtBounds {
  std::size_t lower = 0, upper = 0;
};

/// At is as in Space::at_bounds, and beyond counts as at.
[[nodiscard]] AtBounds count_at_bounds(const Space& space, std::span<const double> x);

/// "3 of 72 coordinates at the lower bound, 1 at the upper"; "no coordinate at a bound".
[[nodiscard]] std::string at_bounds_text(const Space& space, std::span<const double> x);

}  // namespace nodal
