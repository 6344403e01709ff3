// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The loads that can be held out of a fit by name: bodies at rest under stresses of which a closed form is known,
/// whatever their outline is. From the centre of the bounding box, with X, Y, Z in place of x_a − c_a:
///
///     in the plane   bend-x      σ_xx = cY                    bend-y      σ_yy = cX
///                    stretch-45  σ_xx = σ_yy = σ_xy = σ/2: pulled at 45°
///     in space       bend-ab     σ_aa = c x_b, the six of ab
///                    twist-x     σ_xy = −cZ, σ_xz = cY; -y and -z by turning the axes
///     both           the basic loads of `minimal` (nodal/elastic/loads.h)
///
/// c is such that |σ| is the study's `stress` where it is largest: a bending's at the farthest border, a twist's shear
/// at the edges of the box.

#include <string>
#include <vector>

#include "loads/load_spec.h"

namespace nodal::elastic {

/// All of them around a box, in the order above. `stress` in Pa.
[[nodiscard]] std::vector<LoadSpec> unseen_load_specs(std::size_t dimension, const Extent& box, double stress);

/// The bendings: what a study with a closed form holds out when it doesn't say.
[[nodiscard]] std::vector<LoadSpec> bending_specs(std::size_t dimension, const Extent& box, double stress);

}  // namespace nodal::elastic
