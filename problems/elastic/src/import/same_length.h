// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether lengths and places that a file says are those of a net.

#include <cmath>

namespace nodal::elastic {

/// Of the system's size, so that six digits do.
inline constexpr double kSameLength = 1e-6;

[[nodiscard]] inline bool same_length(double a, double b, double size) { return std::abs(a - b) <= kSameLength * size; }

}  // namespace nodal::elastic
