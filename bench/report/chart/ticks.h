// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Round numbers on an axis, and how they are written.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "line_chart.h"

namespace nodal::report {

/// At most `most` within the limits. On a logarithmic axis powers of ten, with 2 and 5, or all between, as there is
/// room; where it spans so little that this leaves fewer than two, as on a linear one: multiples of 1, 2 or 5 times a
/// power of ten.
[[nodiscard]] std::vector<double> ticks(const std::array<double, 2>& limits, Scale scale, std::size_t most);

/// "0.02", "3×10⁻⁵"; of seconds "20 ms".
[[nodiscard]] std::string tick_text(double value, bool seconds);

}  // namespace nodal::report
