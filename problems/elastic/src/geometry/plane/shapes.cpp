// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/body.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::plane {

namespace {

void require_positive(double length, const char* what) {
  if (!(length > 0.0) || !std::isfinite(length))
    throw Refusal(fmt::format("{} must be positive, not {}", what, length));
}

void require_finite(double value, const char* what) {
  if (!std::isfinite(value)) throw Refusal(fmt::format("{} must be finite, not {}", what, value));
}

Ring regular_ring(const Point& centre, double radius, std::size_t sides, double turn) {
  require_positive(radius, "a radius");
  for (const double coordinate : centre) require_finite(coordinate, "a centre's coordinate");
  require_finite(turn, "a turn");
  if (sides < 3) throw Refusal(fmt::format("a polygon needs at least 3 sides, not {}", sides));
  Ring ring;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    ring.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  return ring;
}

}  // namespace

Body rectangle_body(const Point& corner, const Point& size, double thickness) {
  require_positive(size[0], "a rectangle's width");
  require_positive(size[1], "a rectangle's height");
  for (const double coordinate : corner) require_finite(coordinate, "a corner's coordinate");
  const double x0 = corner[0], y0 = corner[1], x1 = x0 + size[0], y1 = y0 + size[1];
  return {.name = fmt::format("rectangle {} × {}", size[0], size[1]),
          .rings = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}},
          .thickness = thickness};
}

Body regular_body(const Point& centre, double radius, std::size_t sides, double turn, double thickness) {
  return {.name = fmt::format("regular polygon of {} sides, radius {}", sides, radius),
          .rings = {regular_ring(centre, radius, sides, turn)},
          .thickness = thickness};
}

Body disc_body(const Point& centre, double radius, std::size_t sides, double thickness) {
  Body body = regular_body(centre, radius, sides, 0.0, thickness);
  body.name = fmt::format("disc of radius {} ({} sides)", radius, sides);
  return body;
}

Body ring_body(const Point& centre, double radius, double hole, std::size_t sides, double thickness) {
  require_positive(hole, "a ring's inner radius");
  Body body = disc_body(centre, radius, sides, thickness);
  if (!(hole < radius * std::cos(std::numbers::pi / static_cast<double>(sides))))
    throw Refusal(
        fmt::format("a ring's inner radius {} must be smaller than its outer one {}, "
                    "by more than what a polygon of {} sides cuts off",
                    hole, radius, sides));
  Ring inside = regular_ring(centre, hole, sides, 0.0);
  body.rings.emplace_back(inside.rbegin(), inside.rend());
  body.name = fmt::format("ring of radii {} and {} ({} sides)", hole, radius, sides);
  return body;
}

}  // namespace nodal::elastic::plane
