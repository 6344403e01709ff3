// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace nodal::report {

/// The cost of what was never reached, in any order.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace nodal::report
