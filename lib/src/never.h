// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace nodal {

/// The cost of what was never reached, and the quality where there is none yet: after all others in every order.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace nodal
