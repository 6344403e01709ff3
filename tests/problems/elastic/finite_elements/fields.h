// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Materials, and displacements of bodies that are known in closed form with the stresses that belong to them.
///
/// A body of any shape has one of these displacements exactly when its border is pulled by that stress (and, where that
/// is not in equilibrium, forces in the body make up for it), and three or six freedoms are put where the field has
/// them.

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Dense>

#include "finite_elements/converge.h"
#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"

namespace nodal::elastic::finite_elements {

inline Compliance isotropic(double young, double poisson) {
  Compliance s{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) s[i][j] = (i == j ? 1.0 : -poisson) / young;
  for (std::size_t i = 3; i < 6; ++i) s[i][i] = 2.0 * (1.0 + poisson) / young;
  return s;
}

inline Compliance plane_strain(double young, double poisson) {
  return isotropic(young / (1.0 - poisson * poisson), poisson / (1.0 - poisson));
}

/// In the plane, axes turned counterclockwise by so many degrees: S = Tᵀ S' T, T what makes a stress the turned axes'.
inline Compliance orthotropic(double ex, double ey, double nu_xy, double gxy, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
  Eigen::Matrix3d own, turn;
  own << 1.0 / ex, -nu_xy / ex, 0.0, -nu_xy / ex, 1.0 / ey, 0.0, 0.0, 0.0, 1.0 / gxy;
  turn << c * c, s * s, 2.0 * c * s, s * s, c * c, -2.0 * c * s, -c * s, c * s, c * c - s * s;
  const Eigen::Matrix3d turned = turn.transpose() * own * turn;
  constexpr std::array<std::size_t, 3> kRows = {0, 1, 5};
  Compliance made{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      made[kRows[static_cast<std::size_t>(i)]][kRows[static_cast<std::size_t>(j)]] = turned(i, j);
  return made;
}

struct Field {
  std::function<Vector(const Vector&)> displacement;
  StressAt stress;
};

inline std::set<std::size_t> labels_of(const Mesh& mesh) { return {mesh.side_label.begin(), mesh.side_label.end()}; }

/// Pulled at all labels, and put in its place at vertices: two in the plane, three in space, not on one line.
inline Problem pulled_as(const Field& field, const Region& region, std::size_t dimension,
                         const std::set<std::size_t>& labels, const std::vector<Vector>& places) {
  Problem problem{{region}, {{}}};
  Group& group = problem.groups.front();
  for (std::size_t k = 0; k < dimension; ++k)  // 2 + 1 freedoms, or 3 + 2 + 1
    for (std::size_t axis = k; axis < dimension; ++axis)
      group.prescribed.push_back({places[k], axis, field.displacement(places[k])[axis]});
  Load load;
  for (const std::size_t label : labels) load.tractions.push_back({label, field.stress});
  group.loads.push_back(load);
  return problem;
}

inline Tensor tensor(double xx, double yy, double xy) { return {{{xx, xy, 0.0}, {xy, yy, 0.0}, {0.0, 0.0, 0.0}}}; }

/// u = ∇φ/2G, φ = e^x cos y: harmonic, so without a force in the body and whatever ν is.
inline Field exponential_field(double shear) {
  return {[=](const Vector& x) {
            const double e = std::exp(x[0]) / (2.0 * shear);
            return Vector{e * std::cos(x[1]), -e * std::sin(x[1]), 0.0};
          },
          [](const Vector& x) {
            const double c = std::exp(x[0]) * std::cos(x[1]), s = std::exp(x[0]) * std::sin(x[1]);
            return tensor(c, -c, -s);
          }};
}

/// The same in space: φ = e^{√2 x} cos y cos z.
inline Field exponential_field_in_space(double shear) {
  const double r = std::numbers::sqrt2;
  return {[=](const Vector& x) {
            const double e = std::exp(r * x[0]) / (2.0 * shear), cy = std::cos(x[1]), cz = std::cos(x[2]);
            return Vector{r * e * cy * cz, -e * std::sin(x[1]) * cz, -e * cy * std::sin(x[2])};
          },
          [=](const Vector& x) {
            const double e = std::exp(r * x[0]), cy = std::cos(x[1]), cz = std::cos(x[2]), sy = std::sin(x[1]),
                         sz = std::sin(x[2]);
            const double xx = 2.0 * e * cy * cz, yy = -e * cy * cz, xy = -r * e * sy * cz, zx = -r * e * cy * sz,
                         yz = e * sy * sz;
            return Tensor{{{xx, xy, zx}, {xy, yy, yz}, {zx, yz, yy}}};
          }};
}

/// Lamé: a ring from radius a to b under the pressure p from within, plane stress.
inline Field ring_field(double young, double poisson, double a, double b, double p) {
  const double mean = p * a * a / (b * b - a * a), away = mean * b * b;
  return {[=](const Vector& x) {
            const double r2 = x[0] * x[0] + x[1] * x[1];
            const double share = ((1.0 - poisson) * mean + (1.0 + poisson) * away / r2) / young;
            return Vector{share * x[0], share * x[1], 0.0};
          },
          [=](const Vector& x) {
            const double r2 = x[0] * x[0] + x[1] * x[1], k = away / r2;
            const double cos2 = (x[0] * x[0] - x[1] * x[1]) / r2, sin2 = 2.0 * x[0] * x[1] / r2;
            return tensor(mean - k * cos2, mean + k * cos2, -k * sin2);
          }};
}

/// Kirsch: a plate pulled by the stress 1 along x far away, about a hole of radius a; plane stress.
inline Field hole_field(double young, double poisson, double a) {
  const double shear = young / (2.0 * (1.0 + poisson)), kappa = (3.0 - poisson) / (1.0 + poisson);
  return {[=](const Vector& x) {
            const double r = std::hypot(x[0], x[1]), t = std::atan2(x[1], x[0]), q = a / r, c = a / (8.0 * shear);
            const double cubed = 2.0 * q * q * q;
            return Vector{c * ((kappa + 1.0) / q * std::cos(t) +
                               2.0 * q * ((1.0 + kappa) * std::cos(t) + std::cos(3.0 * t)) - cubed * std::cos(3.0 * t)),
                          c * ((kappa - 3.0) / q * std::sin(t) +
                               2.0 * q * ((1.0 - kappa) * std::sin(t) + std::sin(3.0 * t)) - cubed * std::sin(3.0 * t)),
                          0.0};
          },
          [=](const Vector& x) {
            const double r2 = x[0] * x[0] + x[1] * x[1], t = std::atan2(x[1], x[0]), q = a * a / r2;
            const double c2 = std::cos(2.0 * t), c4 = std::cos(4.0 * t), s2 = std::sin(2.0 * t), s4 = std::sin(4.0 * t);
            return tensor(1.0 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4, -q * (0.5 * c2 - c4) - 1.5 * q * q * c4,
                          -q * (0.5 * s2 + s4) + 1.5 * q * q * s4);
          }};
}

/// The first symmetric field at the tip of a notch whose free faces lie at ±135° (B. Szabó, I. Babuška): grows like
/// r^0.544; plane stress.
inline Field notch_field(double young, double poisson) {
  const double shear = young / (2.0 * (1.0 + poisson)), kappa = (3.0 - poisson) / (1.0 + poisson);
  const double l = 0.544483736782464, q = 0.543075578836737;
  return {[=](const Vector& x) {
            const double r = std::hypot(x[0], x[1]), t = std::atan2(x[1], x[0]), c = std::pow(r, l) / (2.0 * shear);
            return Vector{c * ((kappa - q * (l + 1.0)) * std::cos(l * t) - l * std::cos((l - 2.0) * t)),
                          c * ((kappa + q * (l + 1.0)) * std::sin(l * t) + l * std::sin((l - 2.0) * t)), 0.0};
          },
          [=](const Vector& x) {
            const double r = std::hypot(x[0], x[1]), t = std::atan2(x[1], x[0]), c = l * std::pow(r, l - 1.0);
            const double c1 = std::cos((l - 1.0) * t), c3 = std::cos((l - 3.0) * t), s1 = std::sin((l - 1.0) * t),
                         s3 = std::sin((l - 3.0) * t);
            return tensor(c * ((2.0 - q * (l + 1.0)) * c1 - (l - 1.0) * c3),
                          c * ((2.0 + q * (l + 1.0)) * c1 + (l - 1.0) * c3), c * ((l - 1.0) * s3 + q * (l + 1.0) * s1));
          }};
}

/// The largest |u − u_exact| at places over the largest |u_exact|.
inline double true_error(const std::vector<Vector>& found, const std::vector<Vector>& places, const Field& field) {
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector exact = field.displacement(places[i]);
    error = std::max(error, distance(found[i], exact));
    largest = std::max(largest, norm(exact));
  }
  return error / largest;
}

}  // namespace nodal::elastic::finite_elements
