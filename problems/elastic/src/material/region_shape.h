// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The border of a region as segments.

#include <array>
#include <vector>

#include <nodal/elastic/material_field.h>

namespace nodal::elastic {

/// What of it is within a box and not along the box's own border, within `tolerance`; in the plane.
[[nodiscard]] std::vector<std::array<plane::Point, 2>> sides_within(const RegionShape& shape, const Extent& box,
                                                                    double tolerance);

/// The shape as rings that enclose the same part of a box, and may reach beyond it; in the plane.
[[nodiscard]] std::vector<plane::Ring> rings_around(const RegionShape& shape, const Extent& box);

}  // namespace nodal::elastic
