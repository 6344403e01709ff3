// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace nodal::elastic {

/// From 1 to the next double: what an operation may be off by, relatively, is half of it.
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace nodal::elastic
