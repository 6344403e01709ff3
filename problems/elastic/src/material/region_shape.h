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

/// Where the segment from p to q crosses rings, as shares of it, with 0 and 1: ascending.
[[nodiscard]] std::vector<double> crossings(const plane::Point& p, const plane::Point& q,
                                            const std::vector<plane::Ring>& rings);

/// The shape as rings that enclose the same part of a box, and may reach beyond it; in the plane.
[[nodiscard]] std::vector<plane::Ring> rings_around(const RegionShape& shape, const Extent& box);

}  // namespace nodal::elastic
