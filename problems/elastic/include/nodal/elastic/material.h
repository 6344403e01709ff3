// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Linear elastic materials, isotropic or orthotropic, and the strain that they answer a stress with: ε = S σ.
///
/// Isotropic: ε_aa = (σ_aa − ν Σ_{b≠a} σ_bb)/E, ε_ab = σ_ab/(2G), G = E/(2(1+ν)), over the axes that the body has. In
/// space E and ν are those of the material, in plane stress too. Plane strain is the same with E' = E/(1−ν²),
/// ν' = ν/(1−ν). The paper's eq. (8) is misprinted and contradicts its own next line.
///
/// Orthotropic, along its own axes: S_aa = 1/E_a, S_ab = −ν_ab/E_a (so ν_ba = ν_ab E_b/E_a), and 1/G_ab. Then turned,
/// S' = Mᵀ S M with σ_own = M σ, which leaves it full. Plane stress takes the rows and columns of xx, yy and xy; plane
/// strain S'_ij = S_ij − S_i,zz S_j,zz/S_zz,zz of them.
///
/// Units    moduli Pa, Poisson's ratios dimensionless, angles degrees.
/// Threads  plain values.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <nodal/elastic/vector.h>

namespace nodal::elastic {

/// A stress (Pa) or a strain: symmetric; in the plane without a third row and column.
using Tensor = std::array<Vector, 3>;

[[nodiscard]] inline Vector operator*(const Tensor& t, const Vector& v) {
  return {dot(t[0], v), dot(t[1], v), dot(t[2], v)};
}

/// The equivalent stress of a stress: √(½ [(xx−yy)² + (yy−zz)² + (zz−xx)²] + 3 (xy² + yz² + zx²)) [Pa]. Of a tensor in
/// the plane zz is 0, as in plane stress.
[[nodiscard]] double von_mises(const Tensor& stress);

/// S of ε = S σ in Voigt's order xx, yy, zz, yz, zx, xy, with γ = 2ε for the last three: symmetric [1/Pa]. Of a body in
/// the plane what its plane stress or strain answers with: rows and columns of zz, yz and zx are 0.
using Compliance = std::array<std::array<double, 6>, 6>;

/// Where the component ab of a tensor stands in Voigt's order.
[[nodiscard]] constexpr std::size_t voigt(std::size_t a, std::size_t b) noexcept { return a == b ? a : 6 - a - b; }

/// Of an isotropic material in a body: in the plane E' and ν', which plane strain changes.
struct Moduli {
  double young = 1.0;    ///< E
  double poisson = 0.3;  ///< ν: what a net of springs is asked to show
  double shear = 0.0;    ///< G, the same in all
};

/// A material in a body of so many dimensions.
class Elasticity {
 public:
  Elasticity(std::size_t dimension, const Moduli& isotropic);
  Elasticity(std::size_t dimension, const Compliance& s);

  [[nodiscard]] std::size_t dimension() const noexcept { return dimension_; }
  /// Symmetric to the last bit.
  [[nodiscard]] Compliance compliance() const;
  /// Of one that is isotropic by its constants; a compliance alone has none, whatever its numbers.
  [[nodiscard]] const std::optional<Moduli>& isotropic() const noexcept { return isotropic_; }

  /// Of a homogeneous stress; moduli divide first.
  [[nodiscard]] Tensor strain(const Tensor& stress) const;
  /// ε_aa · length, or γ_ab · length = 2 ε_ab · length; moduli divide last, which keeps round numbers round.
  [[nodiscard]] double stretched(const Tensor& stress, std::size_t a, std::size_t b, double length) const;
  /// The modulus of a pull along a unit direction d: 1/(d d : S : d d).
  [[nodiscard]] double young_along(const Vector& direction) const;

 private:
  std::size_t dimension_;
  std::array<double, 6> moduli_{};                 ///< m_j = 1/S_jj
  std::array<std::array<double, 6>, 6> ratios_{};  ///< S_ij m_j: ε_i = Σ_j ratio_ij σ_j/m_j
  std::optional<Moduli> isotropic_;
};

enum class Plane { stress, strain };

/// Constants along three axes at right angles, which are the body's turned by `angle` about `axis`, the right-handed
/// way: counterclockwise in the plane, where the axis is z. What plane stress doesn't ask for is not looked at: E_z,
/// ν_xz, ν_yz, G_xz and G_yz.
struct Orthotropic {
  std::array<double, 3> young = {1.0, 1.0, 1.0};    ///< E_x, E_y, E_z
  std::array<double, 3> poisson = {0.0, 0.0, 0.0};  ///< ν_xy, ν_xz, ν_yz: ν_ab = −ε_b/ε_a under a pull along a
  std::array<double, 3> shear = {0.5, 0.5, 0.5};    ///< G_xy, G_xz, G_yz
  double angle = 0.0;                               ///< degrees; of multiples of 90 nothing is rounded
  Vector axis = {0.0, 0.0, 1.0};                    ///< of any length but 0

  friend bool operator==(const Orthotropic&, const Orthotropic&) = default;
};

struct Material {
  double young = 1.0;  ///< of an isotropic material, as poisson
  double poisson = 0.3;
  Plane plane = Plane::stress;  ///< of a body in the plane
  std::optional<Orthotropic> orthotropic = {};

  [[nodiscard]] Elasticity elasticity(std::size_t dimension) const;
  /// The modulus of a pull along a unit direction, by the material's own compliance: that of plane stress, in space and
  /// in plane strain too. E of an isotropic material.
  [[nodiscard]] double young_along(const Vector& direction) const;
  /// The least and the greatest of its E, in the plane of E_x and E_y.
  [[nodiscard]] std::array<double, 2> young_range(std::size_t dimension) const;
  /// Why no body of so many dimensions can be computed with it, in words, with what would be right: constants that are
  /// not positive definite, or next to that; ν above kLargestPoisson in plane strain and in space. Empty where it can.
  [[nodiscard]] std::string flaw(std::size_t dimension) const;

  friend bool operator==(const Material&, const Material&) = default;
};

/// In plane strain and in space: nearer to 1/2 the volume hardly changes, and what is computed has no digits left.
inline constexpr double kLargestPoisson = 0.4999;

}  // namespace nodal::elastic
