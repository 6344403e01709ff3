// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/orthotropic.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

namespace nodal::elastic {

namespace {

// The pairs of axes in the order of Orthotropic's constants.
constexpr std::array<std::pair<std::size_t, std::size_t>, 3> kAxisPairs = {{{0, 1}, {0, 2}, {1, 2}}};

Compliance own_compliance(const Orthotropic& m) {
  Compliance s{};
  for (std::size_t a = 0; a < 3; ++a) s[a][a] = 1.0 / m.young[a];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [a, b] = kAxisPairs[k];
    s[a][b] = s[b][a] = -m.poisson[k] / m.young[a];
    s[voigt(a, b)][voigt(a, b)] = 1.0 / m.shear[k];
  }
  return s;
}

// Of an angle in degrees; exact at multiples of 90.
std::pair<double, double> sine_cosine(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters) / 180.0 * std::numbers::pi;
  const double s = std::sin(rest), c = std::cos(rest);
  switch (quarters & 3) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

// Its columns are the material's axes (Rodrigues).
Tensor rotation(double degrees, const Vector& axis) {
  const auto [s, c] = sine_cosine(degrees);
  const double length = norm(axis);
  const Vector k = {axis[0] / length, axis[1] / length, axis[2] / length};
  Tensor r{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) r[a][b] = (1.0 - c) * k[a] * k[b] + (a == b ? c : 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t next = (a + 1) % 3;
    const double across = s * k[(a + 2) % 3];
    r[next][a] += across;
    r[a][next] -= across;
  }
  return r;
}

// Which component of a tensor an index of Voigt's order is.
constexpr std::array<std::pair<std::size_t, std::size_t>, 6> kComponents = {
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};

// M of σ_own = M σ: σ_own = Rᵀ σ R.
Compliance stress_in_own_axes(const Tensor& r) {
  Compliance m{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const auto [a, b] = kComponents[i];
      const auto [c, d] = kComponents[j];
      m[i][j] = r[c][a] * r[d][b];
      if (c != d) m[i][j] += r[d][a] * r[c][b];
    }
  return m;
}

}  // namespace

Compliance turned_compliance(const Orthotropic& material) {
  const Compliance s = own_compliance(material);
  const Compliance m = stress_in_own_axes(rotation(material.angle, material.axis));
  Compliance turned{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i; j < 6; ++j) {
      for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t l = 0; l < 6; ++l) turned[i][j] += m[k][i] * s[k][l] * m[l][j];
      turned[j][i] = turned[i][j];
    }
  return turned;
}

Compliance in_plane_stress(const Compliance& compliance) {
  Compliance plane{};
  for (const std::size_t i : {0, 1, 5})
    for (const std::size_t j : {0, 1, 5}) plane[i][j] = compliance[i][j];
  return plane;
}

Compliance in_plane_strain(const Compliance& compliance) {
  Compliance plane = in_plane_stress(compliance);
  for (const std::size_t i : {0, 1, 5})
    for (const std::size_t j : {0, 1, 5}) plane[i][j] -= compliance[i][2] * compliance[j][2] / compliance[2][2];
  return plane;
}

// Beyond that the softer axis leaves no digit of what the stiffer one does.
constexpr int kMostDecades = 15;

// By the eigenvalues of S_ab √(E_a E_b): those of an isotropic material are 1 + ν and 1 − 2ν, in plane stress 1 ± ν.
std::string flaw_of(const Orthotropic& m, std::size_t axes) {
  for (std::size_t k = 0; k < (axes == 2 ? 1u : 3u); ++k) {
    const auto [a, b] = kAxisPairs[k];
    if (!(std::abs(std::log10(m.young[a]) - std::log10(m.young[b])) <= kMostDecades))
      return fmt::format(
          "E_{} = {} and E_{} = {} are more than {} powers of ten apart, and nothing can be computed in double "
          "precision "
          "with both",
          kAxisNames[a], m.young[a], kAxisNames[b], m.young[b], kMostDecades);
    const double largest = std::sqrt(m.young[a] / m.young[b]);
    if (!(std::abs(m.poisson[k]) < largest))
      return fmt::format(
          "ν_{0}{1} = {2} with E_{0} = {3} and E_{1} = {4} is no material: a load would gain energy; "
          "|ν_{0}{1}| must be less than √(E_{0}/E_{1}) = {5:.6g}",
          kAxisNames[a], kAxisNames[b], m.poisson[k], m.young[a], m.young[b], largest);
  }
  Eigen::Matrix3d scaled = Eigen::Matrix3d::Identity();
  for (std::size_t k = 0; k < (axes == 2 ? 1u : 3u); ++k) {
    const auto a = static_cast<Eigen::Index>(kAxisPairs[k].first), b = static_cast<Eigen::Index>(kAxisPairs[k].second);
    scaled(a, b) = scaled(b, a) =
        -m.poisson[k] * std::sqrt(m.young[kAxisPairs[k].second] / m.young[kAxisPairs[k].first]);
  }
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled).eigenvalues()[0];
  if (least >= 1.0 - 2.0 * kLargestPoisson) return {};
  return fmt::format(
      "Poisson's ratios {}: the least eigenvalue of S_ab √(E_a E_b) is {:.3g}, and must be at least "
      "{:.1g}, which an isotropic material has at ν = {}; take smaller ones",
      least > 0.0 ? "are too near to those of no material"
                  : "are together those of no material, a load would gain energy",
      least, 1.0 - 2.0 * kLargestPoisson, kLargestPoisson);
}

}  // namespace nodal::elastic
