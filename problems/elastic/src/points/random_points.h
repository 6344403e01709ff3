// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random points in a body, the same for the same seed: some on its outline, corners included, the others inside,
/// uniform or by a density. No triangulation is needed.
///
/// Inner points keep a hundredth of the even spacing from the outline (of half a strip's width, where that is less), so
/// that none is taken for a border point, and from the polygon of the border points, so that a triangulation holds all.
///
/// Units    metres.

#include <cstddef>

#include "geometry/plane/density.h"
#include "points/border_points.h"
#include "points/placement.h"

namespace nodal::elastic::plane {

struct RandomPointsOptions {
  std::size_t inner = 0;   ///< points inside
  std::size_t border = 0;  ///< points on the outline, corners included
  BorderSpread spread = BorderSpread::evenly;
  Density density = {};  ///< of the inner points; border points are spread by length alone
};

/// Numbers for `total` points that are about as dense on the outline as inside: border = perimeter / h with h the even
/// spacing of `total` points, but no fewer than the outline needs and no more than there are. Refusal
/// where that is more than `total`, saying how many are needed.
[[nodiscard]] RandomPointsOptions share_points(const Outline& outline, std::size_t total);

/// Border points first, ring by ring along it, then inner ones. Refusal for too few border points, saying
/// how many are needed, and for a density so uneven that hardly any draw is kept.
[[nodiscard]] PlacedPoints make_random_points(const Outline& outline, const RandomPointsOptions& options,
                                              RandomStream& random);

}  // namespace nodal::elastic::plane
