// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Systems of one net side by side in a page, spring by spring.

#include <span>
#include <string>

#include "show/picture.h"
#include "show/stiffness_colours.h"

namespace nodal::elastic::show {

/// More springs than this are neither told one by one nor drawn once for every optimizer.
inline constexpr std::size_t kMostToldSprings = 400;

/// Every system after the first: at rest in the colours of its stiffnesses, and each spring's stiffness against that of
/// the first; then all stiffnesses as a table, and the data by which springs.js tells of a spring that is pointed at.
/// Empty for fewer than two systems, or more springs.
[[nodiscard]] std::string springs_html(std::span<const Picture> pictures, const StiffnessColours& colours);

}  // namespace nodal::elastic::show
