// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Into which parts layers divide a polygon: of layers that overlap, the last is on top.
///
/// The plane is cut at the heights of all vertices and of all places where sides cross; in between sides don't meet, so
/// that sorted from left to right they bound trapezoids, each of which one part has. No polygon booleans: where
/// rounding decides which of two sides comes first, what is between them is rounding, too.
///
/// Units    metres.
/// Cost     heights × sides that reach over one, n log n in most cases.
/// Threads  pure functions.

#include <vector>

#include <nodal/elastic/body.h>

namespace nodal::elastic::plane {

/// A polygon or several: inside is what an odd number of rings surrounds, whichever way they run.
using Layer = std::vector<Ring>;

/// Moments about `origin` of the parts of a body: [0] what no layer covers, [k] what layers[k − 1] covers and none of
/// those behind it does. Exact but for rounding, about 1e-15 of the body's per trapezoid.
[[nodiscard]] std::vector<Moments> overlay_moments(const Layer& body, const std::vector<Layer>& layers,
                                                   const Point& origin = {0.0, 0.0});

/// m += factor · part.
void add(Moments& m, const Moments& part, double factor);

}  // namespace nodal::elastic::plane
