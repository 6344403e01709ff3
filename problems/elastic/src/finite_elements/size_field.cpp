// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/size_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nodal::elastic::finite_elements {

namespace {

constexpr double kStraight = 2e-3;   // a turn of less is none: λ is above 0.998
constexpr double kDeepest = 1e-10;   // of the reach: nearer all is one size, far above what rounding moves vertices by
constexpr double kPowerStep = 0.05;  // powers are rounded up to these, so that there are few

double angle_of_material(const plane::Point& before, const plane::Point& at, const plane::Point& after) {
  const double ax = at[0] - before[0], ay = at[1] - before[1], bx = after[0] - at[0], by = after[1] - at[1];
  return std::numbers::pi - std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

}  // namespace

double corner_exponent(double angle) {
  if (angle <= std::numbers::pi) return 1.0;
  // Between 1/2 and 1 there is one root besides 1 itself, where the left side is below the right one beyond it.
  const auto excess = [&](double l) { return std::sin(l * angle) + l * std::sin(angle); };
  double low = 0.5, high = 1.0 - 0.25 * (angle / std::numbers::pi - 1.0);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

double crossing_exponent(double contrast) {
  return 4.0 / std::numbers::pi * std::atan(1.0 / std::sqrt(std::max(contrast, 1.0)));
}

void SizeField::grade_corners(const plane::Ring& ring) {
  const std::size_t count = ring.size();
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = angle_of_material(ring[(k + count - 1) % count], ring[k], ring[(k + 1) % count]);
    if (angle < std::numbers::pi + kStraight) continue;
    const double power = 1.0 - corner_exponent(angle) / 2.5;
    grade(ring[k], kPowerStep * std::ceil(power / kPowerStep));
  }
}

double SizeField::at(double x, double y, double least) const {
  double share = 1.0;
  for (const auto& [power, places] : places_) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const plane::Point& p : places) nearest = std::min(nearest, (x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1]));
    nearest = std::max({nearest, least * least, kDeepest * kDeepest * reach_ * reach_});
    share = std::min(share, std::pow(nearest / (reach_ * reach_), 0.5 * power));
  }
  return spacing_ * share;
}

}  // namespace nodal::elastic::finite_elements
