// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/body.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::space {

namespace {

// Forces are stress times area, stiffnesses volume over length squared: beyond these some would be 0 or infinite.
constexpr double kLeastSide = 1e-100, kLargestSide = 1e100;

// What is thin resists bending by the square of that: here by 1e-12 of how it resists stretching, of which double
// precision still tells four digits. At 1e-8 it tells none, and what is held looks as if it weren't.
constexpr double kThinnestBox = 1e-6;

void require_thickness(const Vector& size) {
  const std::size_t thin = static_cast<std::size_t>(std::ranges::min_element(size) - size.begin());
  const std::size_t longest = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  if (size[thin] < kThinnestBox * size[longest])
    throw Refusal(
        fmt::format("a box of {} along {} beside {} along {} is too thin to be computed with; each side must "
                    "be at least {} of the longest",
                    size[thin], kAxisNames[thin], size[longest], kAxisNames[longest], kThinnestBox));
}

}  // namespace

Body box_body(const Vector& corner, const Vector& size) {
  Extent box{corner, corner};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.high[axis] += size[axis];
    if (!(size[axis] > 0.0) || !std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis]))
      throw Refusal(
          fmt::format("a box needs finite, positive sizes; this one has {} along {}", size[axis], kAxisNames[axis]));
    if (size[axis] < kLeastSide || size[axis] > kLargestSide)
      throw Refusal(fmt::format("a box of {} along {} can't be computed with; its sides must be from {} to {} m",
                                size[axis], kAxisNames[axis], kLeastSide, kLargestSide));
    if (!(box.along(axis) > 0.0))
      throw Refusal(fmt::format("a box of {} along {} is nothing beside its place {}", size[axis], kAxisNames[axis],
                                corner[axis]));
  }
  require_thickness(size);
  double farthest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  if (const double rounding = farthest * std::numeric_limits<double>::epsilon(); rounding > kPlaceRounding * box.size())
    throw Refusal(
        fmt::format("the box is so far from the origin, at ({}, {}, {}), that its coordinates are rounded to {:.1g}; "
                    "move it nearer to the origin",
                    corner[0], corner[1], corner[2], rounding));
  Body body;
  body.name = fmt::format("box {:g} × {:g} × {:g}", size[0], size[1], size[2]);
  body.box = box;
  return body;
}

}  // namespace nodal::elastic::space
