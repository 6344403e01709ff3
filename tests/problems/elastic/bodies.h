// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bodies to try geometry on.

#include <cmath>
#include <numbers>

#include <nodal/elastic/body.h>
#include <nodal/random.h>

namespace nodal::elastic {

/// A square of side 3 without its upper right square of side 1: one corner turns inwards.
inline Body ell() { return {.name = "ell", .rings = {{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}}}}; }

/// The square [0, 4]² with the hole [1, 2]².
inline Body frame() {
  Body body = plane::rectangle_body({0, 0}, {4, 4});
  body.rings.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  return body;
}

/// A star-shaped outline about (cx, cy) of 3 to 40 vertices, radii spread by up to a factor of ten; every other one has
/// a star-shaped hole of half the size.
inline Body random_star(RandomStream& random) {
  const double cx = random.uniform(-5.0, 5.0), cy = random.uniform(-5.0, 5.0);
  const std::size_t n = 3 + random.index(38);
  const double least = random.uniform(0.1, 0.95);
  const bool hole = random.index(2) == 0;
  Body body;
  plane::Ring outside, inside;
  for (std::size_t i = 0; i < n; ++i) {
    // Within a third of a sector, so that no sector is as wide as half a turn.
    const double angle =
        2.0 * std::numbers::pi * (static_cast<double>(i) + random.uniform(-0.16, 0.16)) / static_cast<double>(n);
    const double radius = random.uniform(least, 1.0);
    outside.push_back({cx + radius * std::cos(angle), cy + radius * std::sin(angle)});
    inside.push_back({cx + 0.5 * radius * std::cos(angle), cy + 0.5 * radius * std::sin(angle)});
  }
  body.rings.push_back(outside);
  if (hole) body.rings.emplace_back(inside.rbegin(), inside.rend());
  return body;
}

}  // namespace nodal::elastic
