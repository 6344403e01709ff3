// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Compliances of orthotropic materials, in their own axes, turned, and reduced to plane strain.

#include <string>

#include <nodal/elastic/material.h>

namespace nodal::elastic {

/// In the body's axes, all six rows and columns; symmetric to the last bit.
[[nodiscard]] Compliance turned_compliance(const Orthotropic& material);

/// Rows and columns of xx, yy and xy; those of zz, yz and zx become 0. The z axis must be one of symmetry.
[[nodiscard]] Compliance in_plane_stress(const Compliance& compliance);
[[nodiscard]] Compliance in_plane_strain(const Compliance& compliance);

/// Why S isn't positive definite, with what would be right; empty where it is. `axes` 2 looks at what plane stress
/// asks for alone.
[[nodiscard]] std::string flaw_of(const Orthotropic& material, std::size_t axes);

}  // namespace nodal::elastic
