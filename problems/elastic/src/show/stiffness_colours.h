// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stiffnesses as colours on a logarithmic scale, and that scale as it is drawn.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/show/svg.h>
#include "show/picture.h"

namespace nodal::elastic::show {

/// Colours from the softest to the stiffest spring, readable without telling red from green, dark enough on white.
class StiffnessColours {
 public:
  static constexpr std::size_t kSteps = 24;

  explicit StiffnessColours(const std::vector<const Picture*>& pictures);

  /// 0 for the softest, kSteps − 1 for the stiffest.
  [[nodiscard]] std::size_t step(double stiffness) const;
  [[nodiscard]] static std::string colour(std::size_t step);
  [[nodiscard]] double softest() const noexcept { return softest_; }
  [[nodiscard]] double stiffest() const noexcept { return stiffest_; }

 private:
  double softest_ = 0.0, stiffest_ = 0.0;
};

/// A bar of the colours over its axis in N/m: both ends, and the powers of ten between them; a power is left without a
/// number where that would run into another. One patch of colour where all stiffnesses are equal.
[[nodiscard]] Drawing colour_scale(const StiffnessColours& colours, double width);

}  // namespace nodal::elastic::show
