// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A plate and a block of the same sides for homogeneous and linear stresses, and an isotropic material of them.

#include <array>
#include <numeric>

#include <nodal/elastic/loads.h>

#include "loads/closed_form.h"

namespace nodal::elastic {

inline constexpr double kYoung = 2.9, kPoisson = 0.27;
inline const Material kStress = {kYoung, kPoisson, Plane::stress};
inline const Material kStrain = {kYoung, kPoisson, Plane::strain};

inline constexpr std::array<double, 3> kSize = {0.7, 3.3, 1.1};
inline constexpr double kVolume = kSize[0] * kSize[1] * kSize[2];

inline Net plate_net() {
  return make_grid_net(plane::rectangle_body({-0.3, 0.1}, {kSize[0], kSize[1]}, kSize[2]), 4, 6, "crossed");
}
inline Net block_net() {
  return make_block_net(space::box_body({-0.3, 0.1, 5.0}, {kSize[0], kSize[1], kSize[2]}), {4, 6, 3}, "single");
}

/// Of the forces on their reference.
inline double work(const LoadCase& load) {
  return std::inner_product(load.forces.begin(), load.forces.end(), load.reference.begin(), 0.0);
}

}  // namespace nodal::elastic
