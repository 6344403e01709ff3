// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points of the plane, as the elastic problem's geometry holds them.
///
/// Units    metres.

#include <array>
#include <vector>

namespace nodal::elastic {

using Point = std::array<double, 2>;

/// A closed polygon: the last vertex is joined to the first, which isn't repeated.
using Ring = std::vector<Point>;

}  // namespace nodal::elastic
