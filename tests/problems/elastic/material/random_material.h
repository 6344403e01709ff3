// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random materials, bodies and stresses.

#include <cmath>

#include <nodal/elastic/material.h>
#include <nodal/random.h>

namespace nodal::elastic {

/// Of any constants that are those of a material, turned by any angle; in the plane about z.
inline Material random_orthotropic(RandomStream& random, std::size_t dimension, Plane plane = Plane::stress) {
  for (;;) {
    Orthotropic m;
    for (double& e : m.young) e = std::exp(random.uniform(-2.0, 2.0));
    for (double& nu : m.poisson) nu = random.uniform(-0.6, 0.6);
    for (double& g : m.shear) g = std::exp(random.uniform(-2.0, 2.0));
    m.angle = random.uniform(-180.0, 180.0);
    if (dimension == 3)
      for (double& a : m.axis) a = random.uniform(-1.0, 1.0);
    Material material{.plane = plane, .orthotropic = m};
    if (material.flaw(dimension).empty()) return material;
  }
}

inline Tensor random_stress_tensor(RandomStream& random, std::size_t dimension) {
  Tensor stress{};
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = a; b < dimension; ++b) stress[a][b] = stress[b][a] = random.uniform(-1.0, 1.0);
  return stress;
}

/// σ : ε.
inline double product(const Tensor& stress, const Tensor& strain) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) sum += stress[a][b] * strain[a][b];
  return sum;
}

}  // namespace nodal::elastic
