// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/error.h>

#include "geometry/plane/overlay.h"
#include "masses/masses.h"
#include "material/region_parts.h"

namespace nodal::elastic {

namespace {

// [kg/m²] by which a region is heavier than the body.
double excess_of(const MaterialField& material, std::size_t region, double density, const Body& body) {
  return material.density_of(region, density) * material.thickness_of(region, body.thickness) -
         density * body.thickness;
}

}  // namespace

std::vector<double> masses_per_area(const MaterialField& material, double density, const Body& body) {
  std::vector<double> masses;
  for (std::size_t k = 0; k <= material.regions.size(); ++k)
    masses.push_back(material.density_of(k, density) * material.thickness_of(k, body.thickness));
  return masses;
}

bool has_uneven_mass(const MaterialField& material, double density, const Body& body) {
  for (std::size_t k = 1; k <= material.regions.size(); ++k)
    if (excess_of(material, k, density, body) != 0.0) return true;
  return false;
}

plane::Moments excess_moments(const std::vector<plane::Ring>& part, const MaterialField& material, double density,
                              const Body& body, const plane::Point& origin) {
  const std::vector<plane::Moments> parts = plane::overlay_moments(part, layers_of(material, extent_of(body)), origin);
  plane::Moments sum;
  for (std::size_t k = 1; k < parts.size(); ++k) add(sum, parts[k], excess_of(material, k, density, body));
  return sum;
}

MassTarget mass_target(const Body& body, double density, const MaterialField& material) {
  if (!body.has_outline()) throw Refusal("a body without an outline has no mass");
  const plane::Box box = plane::bounding_box(body.rings[0]);
  MassTarget target;
  target.origin = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
  plane::Moments& m = target.moments = plane::moments(body.rings, target.origin);
  for (double* value : {&m.area, &m.first[0], &m.first[1], &m.xx, &m.xy, &m.yy}) *value *= density * body.thickness;
  if (has_uneven_mass(material, density, body))
    add(m, excess_moments(body.rings, material, density, body, target.origin), 1.0);
  return target;
}

}  // namespace nodal::elastic
