// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/region_parts.h"

#include "geometry/plane/overlay.h"
#include "material/region_shape.h"

namespace nodal::elastic {

namespace {

// Between the planes of all faces no box begins or ends.
std::vector<double> volumes(const MaterialField& field, const Extent& box) {
  std::array<std::vector<double>, 3> planes = border_planes(field, box);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes[axis].insert(planes[axis].begin(), box.low[axis]);
    planes[axis].push_back(box.high[axis]);
  }
  std::vector<double> parts(1 + field.regions.size(), 0.0);
  for (std::size_t i = 0; i + 1 < planes[0].size(); ++i)
    for (std::size_t j = 0; j + 1 < planes[1].size(); ++j)
      for (std::size_t k = 0; k + 1 < planes[2].size(); ++k) {
        const Vector low = {planes[0][i], planes[1][j], planes[2][k]};
        const Vector size = Vector{planes[0][i + 1], planes[1][j + 1], planes[2][k + 1]} - low;
        const Vector middle = {low[0] + 0.5 * size[0], low[1] + 0.5 * size[1], low[2] + 0.5 * size[2]};
        parts[field.region_at(middle)] += size[0] * size[1] * size[2];
      }
  return parts;
}

std::vector<double> areas(const MaterialField& field, const Body& body) {
  std::vector<double> parts;
  for (const plane::Moments& part : plane::overlay_moments(body.rings, layers_of(field, extent_of(body))))
    parts.push_back(part.area);
  return parts;
}

}  // namespace

std::vector<std::vector<plane::Ring>> layers_of(const MaterialField& field, const Extent& box) {
  std::vector<std::vector<plane::Ring>> layers;
  for (const Region& region : field.regions) layers.push_back(rings_around(region.shape, box));
  return layers;
}

std::vector<double> region_shares(const MaterialField& field, const Body& body) {
  std::vector<double> parts(1 + field.regions.size(), 0.0);
  if (body.box)
    parts = volumes(field, *body.box);
  else if (body.has_outline())
    parts = areas(field, body);
  else
    parts[kBodyRegion] = 1.0;
  double whole = 0.0;
  for (const double part : parts) whole += part;
  for (double& part : parts) part = part > kPlaceRounding * whole ? part / whole : 0.0;
  return parts;
}

}  // namespace nodal::elastic
