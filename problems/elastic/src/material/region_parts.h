// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How much of a body its regions have.

#include <vector>

#include <nodal/elastic/body.h>
#include <nodal/elastic/material_field.h>

namespace nodal::elastic {

/// The regions' shapes, as they cover a part of a body within a box; in the plane.
[[nodiscard]] std::vector<std::vector<plane::Ring>> layers_of(const MaterialField& field, const Extent& box);

/// Shares of area or volume: [0] of what no region covers, [k] of what region k − 1 covers and none behind it does.
/// Exact but for rounding; what is below kPlaceRounding is 0. All of it is the body's own where it has no border.
[[nodiscard]] std::vector<double> region_shares(const MaterialField& field, const Body& body);

}  // namespace nodal::elastic
