// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The numbers that aren't.

#include <limits>

namespace nodal::toy {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace nodal::toy
