// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How thick a body in the plane is along the pieces of its border, where regions of material have thicknesses of
/// their own.
///
/// Units    m.

#include <array>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// Some region has another thickness than the body.
[[nodiscard]] bool has_uneven_thickness(const MaterialField& material, const Body& body);

/// Of each piece of the border, in the order of for_each_border_piece, ∫ t (1 − s) ds and ∫ t s ds, with s from 0 at
/// its first node to 1 at its second, along the border between them: what its nodes get of a constant pull, so that
/// force and torque are those of the border itself where it is straight between them. t is the thickness just inside
/// the body, and the border is cut where those of regions cross it: exact but for where that is, which is known to
/// some kPlaceRounding of the body's size.
/// Cost     sides of the border × sides of regions.
[[nodiscard]] std::vector<std::array<double, 2>> thickness_shares(const Net& net, const MaterialField& material);

}  // namespace nodal::elastic
