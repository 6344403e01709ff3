// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/material.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "material/orthotropic.h"

namespace nodal::elastic {

namespace {

// What keeps the third axis: nothing, or its own compliance, or all around it.
enum class StressState { space, plane_stress, plane_strain };

StressState state_of(const Material& material, std::size_t dimension) {
  if (dimension == 3) return StressState::space;
  return material.plane == Plane::stress ? StressState::plane_stress : StressState::plane_strain;
}

// σ in Voigt's order.
std::array<double, 6> in_voigt(const Tensor& t) { return {t[0][0], t[1][1], t[2][2], t[1][2], t[2][0], t[0][1]}; }

double squared(double x) { return x * x; }

double young_of(const Compliance& s, const Vector& d) {
  const std::array<double, 6> pull = {d[0] * d[0], d[1] * d[1], d[2] * d[2], d[1] * d[2], d[2] * d[0], d[0] * d[1]};
  double stretch = 0.0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) stretch += pull[i] * s[i][j] * pull[j];
  return 1.0 / stretch;
}

}  // namespace

double von_mises(const Tensor& t) {
  return std::sqrt(0.5 * (squared(t[0][0] - t[1][1]) + squared(t[1][1] - t[2][2]) + squared(t[2][2] - t[0][0])) +
                   3.0 * (squared(t[0][1]) + squared(t[1][2]) + squared(t[2][0])));
}

Elasticity Material::elasticity(std::size_t dimension) const {
  const StressState state = state_of(*this, dimension);
  if (orthotropic) {
    const Compliance s = turned_compliance(*orthotropic);
    return {dimension, state == StressState::space          ? s
                       : state == StressState::plane_stress ? in_plane_stress(s)
                                                            : in_plane_strain(s)};
  }
  const double shear = young / (2.0 * (1.0 + poisson));
  if (state == StressState::plane_strain)
    return {dimension, Moduli{young / (1.0 - poisson * poisson), poisson / (1.0 - poisson), shear}};
  return {dimension, Moduli{young, poisson, shear}};
}

double Material::young_along(const Vector& direction) const {
  return orthotropic ? young_of(turned_compliance(*orthotropic), direction) : young;
}

std::array<double, 2> Material::young_range(std::size_t dimension) const {
  if (!orthotropic) return {young, young};
  const auto& e = orthotropic->young;
  const auto [least, greatest] = std::minmax_element(e.begin(), e.begin() + static_cast<std::ptrdiff_t>(dimension));
  return {*least, *greatest};
}

std::string Material::flaw(std::size_t dimension) const {
  const StressState state = state_of(*this, dimension);
  if (orthotropic) return flaw_of(*orthotropic, state == StressState::plane_stress ? 2 : 3);
  if (state == StressState::plane_stress || poisson <= kLargestPoisson) return {};
  return fmt::format("'poisson' is {}: in {} a body this incompressible can't be computed with; it must be ≤ {}",
                     poisson, state == StressState::space ? "space" : "plane strain", kLargestPoisson);
}

Elasticity::Elasticity(std::size_t dimension, const Moduli& isotropic) : dimension_(dimension), isotropic_(isotropic) {
  moduli_.fill(1.0);
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < dimension; ++b) {
      const std::size_t i = voigt(a, b);
      moduli_[i] = a == b ? isotropic.young : isotropic.shear;
      ratios_[i][i] = 1.0;
      if (a != b) ratios_[a][b] = -isotropic.poisson;
    }
}

Elasticity::Elasticity(std::size_t dimension, const Compliance& s) : dimension_(dimension) {
  for (std::size_t j = 0; j < 6; ++j) {
    moduli_[j] = s[j][j] > 0.0 ? 1.0 / s[j][j] : 1.0;
    for (std::size_t i = 0; i < 6; ++i) ratios_[i][j] = i == j ? (s[j][j] > 0.0 ? 1.0 : 0.0) : s[i][j] * moduli_[j];
  }
}

Compliance Elasticity::compliance() const {
  Compliance s{};
  for (std::size_t j = 0; j < 6; ++j)
    for (std::size_t i = 0; i <= j; ++i) s[i][j] = s[j][i] = ratios_[i][j] / moduli_[j];
  return s;
}

Tensor Elasticity::strain(const Tensor& stress) const {
  const std::array<double, 6> sigma = in_voigt(stress);
  Tensor strain{};
  for (std::size_t a = 0; a < dimension_; ++a)
    for (std::size_t b = 0; b < dimension_; ++b) {
      for (std::size_t j = 0; j < 6; ++j) strain[a][b] += ratios_[voigt(a, b)][j] * (sigma[j] / moduli_[j]);
      if (a != b) strain[a][b] *= 0.5;
    }
  return strain;
}

double Elasticity::stretched(const Tensor& stress, std::size_t a, std::size_t b, double length) const {
  const std::array<double, 6> sigma = in_voigt(stress);
  double sum = 0.0;
  for (std::size_t j = 0; j < 6; ++j) sum += ratios_[voigt(a, b)][j] * sigma[j] * length / moduli_[j];
  return sum;
}

double Elasticity::young_along(const Vector& direction) const {
  return isotropic_ ? isotropic_->young : young_of(compliance(), direction);
}

}  // namespace nodal::elastic
