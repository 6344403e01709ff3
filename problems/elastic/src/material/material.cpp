// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/material.h>

namespace nodal::elastic {

Elasticity Material::elasticity(std::size_t dimension) const {
  const double shear = young / (2.0 * (1.0 + poisson));
  if (dimension == 2 && plane == Plane::strain)
    return {dimension, young / (1.0 - poisson * poisson), poisson / (1.0 - poisson), shear};
  return {dimension, young, poisson, shear};
}

Tensor Elasticity::strain(const Tensor& stress) const {
  Tensor strain{};
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < dimension; ++b)
      if (a == b) {
        strain[a][a] += stress[a][a] / young;
      } else {
        strain[a][a] -= poisson * (stress[b][b] / young);
        strain[a][b] = 0.5 * stress[a][b] / shear;
      }
  return strain;
}

}  // namespace nodal::elastic
