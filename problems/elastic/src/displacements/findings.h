// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The finding of every point: k_max / k_min, the stiffest spring over the softest.

#include <span>
#include <string_view>

#include <nodal/evaluator.h>

namespace nodal::elastic {

inline constexpr std::string_view kSpread = "spread";

[[nodiscard]] Finding spread_of(std::span<const double> stiffness);

}  // namespace nodal::elastic
