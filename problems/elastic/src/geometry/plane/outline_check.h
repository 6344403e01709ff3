// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// From rings that people wrote to a body: small things are mended and said, the others refused with their place.
///
/// rings[0] is the outline, the others are holes, and "hole 1" is rings[1]. Vertices and sides are numbered from 0 as
/// they were given; side i runs from vertex i to the next, the last one to vertex 0.
///
/// Mended   a last vertex that repeats the first is dropped; a ring the wrong way round is turned round, which
///          Body::remarks tells; Body::side knows the numbers that were given.
/// Refused  fewer than 3 points; a point that is not finite, or out of range; an outline so far from the origin that
///          its coordinates are coarser than the tolerance; vertices, or a vertex and a side, nearer to each other than
///          the tolerance; sides that cross; a side that folds back on its predecessor; rings without area; holes not
///          inside the outline, or within each other; more than kMostHoles of them.
/// The tolerance is kPlaceRounding of the outline's size: nearer than that, sides differ by rounding alone.
/// Sides may be collinear, and turns may be as sharp as the tolerance lets them.
///
/// Why not Boost.Geometry's is_valid: 1.74 compares on an integer grid of about 1e-7 of the size. For the square
/// (0 0, 1 0, 0.5 -1e-8, 1 1, 0 1), whose side crosses the bottom, it says valid, and for a notch 1e-8 wide it says
/// invalid; with 50,000 vertices it takes 5 s.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/body.h>
#include <nodal/error.h>

namespace nodal::elastic::plane {

/// The second moments are fourth powers of lengths; within these they and their sums stay in double precision.
inline constexpr double kLargestCoordinate = 1e75, kSmallestBody = 1e-75;

/// Each of them takes nodes of its own, so more are taken for a mistake.
inline constexpr std::size_t kMostHoles = 10000;

/// InputError at `source` for what is refused above. std::invalid_argument without rings, or for a thickness that is
/// not positive.
///
/// Cost     that of find_side_conflict (side_conflict.h): 10 ms for a gear of 10,000 vertices.
[[nodiscard]] Body checked_body(std::vector<Ring> rings, std::string name, double thickness, double corner_turn,
                                const Source& source);

}  // namespace nodal::elastic::plane
