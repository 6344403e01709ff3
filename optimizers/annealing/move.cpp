// SPDX-License-Identifier: GPL-3.0-or-later
#include "move.h"

#include <algorithm>
#include <cmath>

namespace nodal::annealing {

double reflect(double value, double lower, double upper) {
  if (lower <= value && value <= upper) return value;
  const double width = upper - lower;
  double offset = std::fmod(std::abs(value - lower), 2.0 * width);
  if (offset > width) offset = 2.0 * width - offset;
  return std::clamp(lower + offset, lower, upper);
}

Move propose_move(const Space& space, std::span<const double> current, double step, RandomStream& random) {
  const std::size_t i = random.index(space.size());
  return {i, reflect(current[i] + random.uniform(-step, step), space.lower()[i], space.upper()[i])};
}

}  // namespace nodal::annealing
