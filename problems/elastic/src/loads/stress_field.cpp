// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/stress_field.h"

#include <cmath>

namespace nodal::elastic {

Tensor growth(const StressGradient& gradient, const Vector& away) {
  Tensor sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) sum[a][b] += gradient[axis][a][b] * away[axis];
  return sum;
}

Tensor StressField::at(const Vector& place) const {
  Tensor stress = growth(gradient, place - centre);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) stress[a][b] += at_centre[a][b];
  return stress;
}

bool is_homogeneous(const StressGradient& gradient) { return gradient == StressGradient{}; }

bool in_equilibrium(const StressGradient& gradient) {
  constexpr double kRounding = 1e-12;
  for (std::size_t a = 0; a < 3; ++a) {
    double pull = 0.0, size = 0.0;
    for (std::size_t b = 0; b < 3; ++b) {
      pull += gradient[b][a][b];
      size += std::abs(gradient[b][a][b]);
    }
    if (!(std::abs(pull) <= kRounding * size)) return false;
  }
  return true;
}

}  // namespace nodal::elastic
