// SPDX-License-Identifier: GPL-3.0-or-later
#include "masses/cell_integrals.h"

#include <algorithm>
#include <stdexcept>

#include "geometry/plane/overlay.h"
#include "material/region_parts.h"

namespace nodal::elastic {

std::vector<double> cell_integrals(plane::VoronoiCells& cells, const MaterialField& material, const Body& body,
                                   std::span<const double> by_region) {
  if (by_region.size() != 1 + material.regions.size())
    throw std::invalid_argument("cell_integrals: one value per region, and one of the body's own");
  const double own = by_region[kBodyRegion];
  std::vector<double> integrals;
  for (const plane::CellSums& cell : cells.cells()) integrals.push_back(own * cell.area);
  if (std::ranges::count(by_region, own) == static_cast<std::ptrdiff_t>(by_region.size())) return integrals;
  const std::vector<plane::Layer> layers = layers_of(material, extent_of(body));
  for (std::size_t i = 0; i < integrals.size(); ++i) {
    const std::vector<plane::Moments> parts = plane::overlay_moments(cells.rings(i), layers);
    double more = 0.0;
    for (std::size_t k = 1; k < parts.size(); ++k) more += (by_region[k] - own) * parts[k].area;
    integrals[i] += more;
  }
  return integrals;
}

}  // namespace nodal::elastic
