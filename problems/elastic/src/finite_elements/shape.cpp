// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/shape.h"

#include <cmath>

namespace nodal::elastic::finite_elements {

namespace {

// λ = a but for one, which is `b`, in all orders.
void append_orbit(std::size_t dimension, double a, double b, double weight, std::vector<QuadraturePoint>& points) {
  for (std::size_t k = 0; k <= dimension; ++k) {
    QuadraturePoint point{{}, weight};
    for (std::size_t i = 0; i <= dimension; ++i) point.at[i] = i == k ? b : a;
    points.push_back(point);
  }
}

std::vector<QuadraturePoint> orbit(std::size_t dimension, double a) {
  const double d = static_cast<double>(dimension);
  std::vector<QuadraturePoint> points;
  append_orbit(dimension, a, 1.0 - d * a, 1.0 / (d + 1.0), points);
  return points;
}

std::vector<QuadraturePoint> on_line() {
  const double away = 0.5 * std::sqrt(0.6);
  std::vector<QuadraturePoint> points = {{{0.5, 0.5}, 4.0 / 9.0}};
  append_orbit(1, 0.5 - away, 0.5 + away, 5.0 / 18.0, points);
  return points;
}

std::vector<QuadraturePoint> on_triangle() {
  std::vector<QuadraturePoint> points;
  append_orbit(2, 0.445948490915965, 1.0 - 2.0 * 0.445948490915965, 0.223381589678011, points);
  append_orbit(2, 0.091576213509771, 1.0 - 2.0 * 0.091576213509771, 0.109951743655322, points);
  return points;
}

}  // namespace

const std::vector<QuadraturePoint>& cell_quadrature(std::size_t dimension) {
  static const std::array<std::vector<QuadraturePoint>, 4> kRules = {
      {{}, {}, orbit(2, 1.0 / 6.0), orbit(3, (5.0 - std::sqrt(5.0)) / 20.0)}};
  return kRules.at(dimension);
}

const std::vector<QuadraturePoint>& side_quadrature(std::size_t dimension) {
  static const std::array<std::vector<QuadraturePoint>, 3> kRules = {{{}, on_line(), on_triangle()}};
  return kRules.at(dimension);
}

}  // namespace nodal::elastic::finite_elements
