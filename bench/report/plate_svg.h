// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Draws plates as in the paper's Figure 8: the body's own deformation dotted, the spring system's on top, each spring
/// coloured by its stiffness on a logarithmic scale.

#include <string>
#include <vector>

#include "plate.h"

namespace nodal::report {

/// Colours from the softest to the stiffest spring, readable without telling red from green, dark enough on white.
class StiffnessColours {
 public:
  static constexpr std::size_t kSteps = 24;

  explicit StiffnessColours(const std::vector<const Plate*>& plates);

  /// 0 for the softest, kSteps − 1 for the stiffest.
  [[nodiscard]] std::size_t step(double stiffness) const;
  [[nodiscard]] static std::string colour(std::size_t step);
  [[nodiscard]] double softest() const noexcept { return softest_; }
  [[nodiscard]] double stiffest() const noexcept { return stiffest_; }

 private:
  double softest_ = 0.0, stiffest_ = 0.0;
};

/// What all panels of a problem share, so that they compare: metres to drawing units, and the scale of displacements.
struct PlateFrame {
  Vector2 low = {0.0, 0.0};  ///< metres, lower left of the picture
  double unit = 1.0;         ///< drawing units per metre
  double width = 0.0, height = 0.0;
  double magnification = 1.0;  ///< displacements are drawn this much larger: 1, 2 or 5 times a power of ten
  double arrow = 0.0;          ///< drawing units per newton

  [[nodiscard]] Vector2 at(const Vector2& node, const Vector2& displacement) const;
};
[[nodiscard]] PlateFrame make_frame(const std::vector<const Plate*>& plates);

/// The largest of 1, 2, 5 × a power of ten that is not above `value`, which is positive.
[[nodiscard]] double round_down_125(double value);

/// One load of one plate: a complete <svg> element.
[[nodiscard]] std::string panel_svg(const Plate& plate, const PlateLoad& load, const PlateFrame& frame,
                                    const StiffnessColours& colours);

}  // namespace nodal::report
