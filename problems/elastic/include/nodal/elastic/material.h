// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Linear elastic, isotropic, homogeneous material, and the strain that it answers a stress with.
///
/// ε_aa = (σ_aa − ν Σ_{b≠a} σ_bb)/E, ε_ab = σ_ab/(2G), over the axes that the body has. In space E and ν are those of
/// the material, in plane stress too. Plane strain is the same with E' = E/(1−ν²), ν' = ν/(1−ν). The paper's eq. (8) is
/// misprinted and contradicts its own next line.
///
/// Units    young Pa, poisson dimensionless.

#include <array>
#include <cstddef>

#include <nodal/elastic/vector.h>

namespace nodal::elastic {

/// A stress (Pa) or a strain: symmetric; in the plane without a third row and column.
using Tensor = std::array<Vector, 3>;

[[nodiscard]] inline Vector operator*(const Tensor& t, const Vector& v) {
  return {dot(t[0], v), dot(t[1], v), dot(t[2], v)};
}

/// S of ε = S σ in Voigt's order xx, yy, zz, yz, zx, xy, with γ = 2ε for the last three: symmetric [1/Pa]. Of a body in
/// the plane what its plane stress or strain answers with: rows and columns of zz, yz and zx are 0.
using Compliance = std::array<std::array<double, 6>, 6>;

/// A material in a body of so many dimensions.
struct Elasticity {
  std::size_t dimension = 2;
  double young = 1.0;    ///< E, in the plane E'
  double poisson = 0.3;  ///< ν, in the plane ν': what a net of springs is asked to show
  double shear = 0.0;    ///< G = E/(2(1+ν)), the same in all

  /// Of a homogeneous stress; moduli divide first.
  [[nodiscard]] Tensor strain(const Tensor& stress) const;
};

enum class Plane { stress, strain };

struct Material {
  double young = 1.0;
  double poisson = 0.3;
  Plane plane = Plane::stress;  ///< of a body in the plane

  [[nodiscard]] Elasticity elasticity(std::size_t dimension) const;
};

}  // namespace nodal::elastic
