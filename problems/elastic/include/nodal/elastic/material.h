// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Linear elastic, isotropic, homogeneous material in the plane, and its homogeneous stress states.
///
/// Plane stress: ε = (1/E) [[1, −ν, 0], [−ν, 1, 0], [0, 0, 2(1+ν)]] σ. The paper's eq. (8) is misprinted and
/// contradicts its own next line. Plane strain is the same with E' = E/(1−ν²), ν' = ν/(1−ν). Units    young Pa, poisson
/// dimensionless.

namespace nodal::elastic {

enum class Plane { stress, strain };

struct Material {
  double young = 1.0;
  double poisson = 0.3;
  Plane plane = Plane::stress;

  /// E of the equivalent plane-stress material (E itself in plane stress).
  [[nodiscard]] double plane_young() const;
  /// ν of the equivalent plane-stress material: what a net of springs is asked to show.
  [[nodiscard]] double plane_poisson() const;
  /// G = E/(2(1+ν)), the same in both.
  [[nodiscard]] double shear_modulus() const;
};

}  // namespace nodal::elastic
