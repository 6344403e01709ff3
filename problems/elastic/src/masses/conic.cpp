// SPDX-License-Identifier: GPL-3.0-or-later
#include "conic.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

constexpr double kZero = 1e-7;

// "two rows, y = 0 and y = 1" for c + b t + a t² = 0 in the one coordinate that the curve is about; nothing is written
// for a polynomial without real roots, which no nodes lie on.
std::string lines(double c, double b, double a, double middle, double scale, const char* many, const char* one,
                  const char* axis) {
  const auto place = [&](double t) {
    const double x = middle + scale * t;
    return std::abs(x) < 1e-12 * (std::abs(middle) + scale) ? 0.0 : x;
  };
  if (std::abs(a) < kZero) return fmt::format("one {}, {} = {:.6g}", one, axis, place(-c / b));
  const double half = -0.5 * b / a, root = std::sqrt(std::max(0.0, half * half - c / a));
  if (root < kZero) return fmt::format("one {}, {} = {:.6g}", one, axis, place(half));
  return fmt::format("two {}, {} = {:.6g} and {} = {:.6g}", many, axis, place(half - root), axis, place(half + root));
}

// By the discriminant of the second-degree part, and by whether the conic falls apart into lines.
std::string conic(std::span<const double, 6> q) {
  const double c = q[0], d = q[1], e = q[2], a = q[3], b = q[4], f = q[5];
  const double discriminant = b * b - 4.0 * a * f;
  const double determinant =
      c * (a * f - 0.25 * b * b) - 0.25 * (d * (d * f - 0.5 * b * e) + e * (a * e - 0.5 * b * d));
  const bool degenerate = std::abs(determinant) < kZero;
  if (std::abs(discriminant) < kZero) return degenerate ? "two parallel lines" : "a parabola";
  if (discriminant < 0.0) return "an ellipse";
  return degenerate ? "two crossing lines" : "a hyperbola";
}

}  // namespace

std::string describe_curve(std::span<const double, 6> given, const plane::Point& middle, const plane::Point& scale) {
  std::array<double, 6> q{};
  const double largest = std::abs(*std::ranges::max_element(given, {}, [](double v) { return std::abs(v); }));
  for (std::size_t k = 0; k < 6; ++k) q[k] = std::abs(given[k]) < kZero * largest ? 0.0 : given[k] / largest;
  const bool of_x = q[1] != 0.0 || q[3] != 0.0, of_y = q[2] != 0.0 || q[5] != 0.0, mixed = q[4] != 0.0;
  std::string curve;
  if (!mixed && !of_x)
    curve = lines(q[0], q[2], q[5], middle[1], scale[1], "rows", "row", "y");
  else if (!mixed && !of_y)
    curve = lines(q[0], q[1], q[3], middle[0], scale[0], "columns", "column", "x");
  else if (!mixed && q[3] == 0.0 && q[5] == 0.0)
    curve = "one straight line";
  else
    curve = "one conic, " + conic(q);
  return "all nodes lie on " + curve;
}

}  // namespace nodal::elastic
