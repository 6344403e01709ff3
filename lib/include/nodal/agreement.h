// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// When a cost that a race has seen and a fresh evaluation of the same point say the same.
///
/// Costs are dimensionless, so r = √(2 cost) has a scale of its own: for the elastic problem it is the relative error.
/// A race's evaluation gives r to kRaceAccuracy. Near a perfect fit that is all there is to say: relative to itself
/// such a cost is rounding.

#include <algorithm>
#include <cmath>
#include <limits>

namespace nodal {

/// What an evaluation as accurate as a race needs may have r = √(2 cost) off by.
inline constexpr double kRaceAccuracy = 1e-10;
/// A cost below this is a perfect fit, as far as races can tell.
inline constexpr double kPerfectCost = 0.5 * kRaceAccuracy * kRaceAccuracy;
/// Relative to the cost: what was seen may be better than the truth by this, beyond the accuracy of a race.
inline constexpr double kLargestContradiction = 1e-6;

/// |seen − fresh| relative to the fresh cost, or to a perfect one where that is larger.
[[nodiscard]] inline double relative_drift(double seen, double fresh) noexcept {
  return std::abs(seen - fresh) / std::max(std::abs(fresh), kPerfectCost);
}

/// How many digits of a number hold that is off by this share of itself: as many as doubles have, at most.
[[nodiscard]] inline double digits_that_hold(double off) noexcept {
  constexpr double kMost = std::numeric_limits<double>::digits10 + 1;
  return off > 0.0 ? std::clamp(0.0 - std::log10(off), 0.0, kMost) : kMost;
}

/// True when the fresh cost refutes what was seen: it is worse by more than 1e-6 of itself and by more than
/// kRaceAccuracy in r. What was seen as worse than it is has misled nobody.
[[nodiscard]] inline bool contradicts(double seen, double fresh) noexcept {
  const double accuracy = kRaceAccuracy * std::sqrt(2.0 * std::abs(fresh)) + kPerfectCost;
  return fresh - seen > kLargestContradiction * std::abs(fresh) + accuracy;
}

}  // namespace nodal
