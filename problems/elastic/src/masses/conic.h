// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The curve q(ξ, η) = 0 of second or lower degree that nodes lie on, in words.

#include <array>
#include <span>
#include <string>

#include <nodal/elastic/point.h>

namespace nodal::elastic {

/// Powers of ξ and η in the order of coefficients here: 1, ξ, η, ξ², ξη, η².
inline constexpr std::array<std::array<int, 2>, 6> kMonomialPowers = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// "all nodes lie on two rows, y = 0 and y = 1". q has six coefficients, the largest about 1; what is below 1e-7 counts
/// as zero. ξ = (x − middle[0])/scale[0], η likewise.
[[nodiscard]] std::string describe_curve(std::span<const double, 6> q, const plane::Point& middle,
                                         const plane::Point& scale);

}  // namespace nodal::elastic
