// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// When a trial arrives that doesn't.

#include <limits>

namespace nodal::statistics {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace nodal::statistics
