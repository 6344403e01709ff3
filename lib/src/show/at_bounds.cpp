// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/show/at_bounds.h>

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace nodal {

AtBounds count_at_bounds(const Space& space, std::span<const double> x) {
  // In the middle of their intervals, those of the upper half are at none.
  std::vector<double> lower_half(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i)
    lower_half[i] = std::min(x[i], 0.5 * (space.lower()[i] + space.upper()[i]));
  const std::size_t lower = space.at_bounds(lower_half);
  return {lower, space.at_bounds(x) - lower};
}

std::string at_bounds_text(const Space& space, std::span<const double> x) {
  const AtBounds at = count_at_bounds(space, x);
  const std::size_t lower = at.lower, upper = at.upper;
  if (lower + upper == 0) return "no coordinate at a bound";
  if (lower == 0) return fmt::format("{} of {} coordinates at the upper bound", upper, x.size());
  return fmt::format("{} of {} coordinates at the lower bound{}", lower, x.size(),
                     upper > 0 ? fmt::format(", {} at the upper", upper) : "");
}

}  // namespace nodal
