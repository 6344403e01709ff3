// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/material.h>

namespace nodal::elastic {

double Material::plane_young() const { return plane == Plane::stress ? young : young / (1.0 - poisson * poisson); }
double Material::plane_poisson() const { return plane == Plane::stress ? poisson : poisson / (1.0 - poisson); }
double Material::shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }

}  // namespace nodal::elastic
