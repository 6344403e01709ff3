// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Uniform random points in a polygon with holes, without rejection: the body is cut at the heights of its vertices
/// into trapezoids, of which one is drawn by area. Slender bodies cost no more than others.
///
/// Cost     to build, heights × sides in the worst case, n log n in most; a draw takes log n.
/// Threads  immutable once built; the random stream is the caller's.

#include <vector>

#include <nodal/random.h>

#include "geometry/plane/outline.h"

namespace nodal::elastic::plane {

class AreaSampler {
 public:
  explicit AreaSampler(const Outline& outline);

  [[nodiscard]] Point draw(RandomStream& random) const;

 private:
  /// Between two heights, from the left to the right side: x at the lower and at the upper height.
  struct Trapezoid {
    double low, high;
    double left_low, left_high, right_low, right_high;
  };

  std::vector<Trapezoid> trapezoids_;
  std::vector<double> areas_up_to_;  // [trapezoids] summed
};

}  // namespace nodal::elastic::plane
