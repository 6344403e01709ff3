// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/material_field.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/plane/ring_tree.h"
#include "material/region_shape.h"

namespace nodal::elastic {

namespace {

bool covers(const HalfPlane& half, const Vector& place, double tolerance) {
  const double beyond = (place[0] - half.point[0]) * half.towards[0] + (place[1] - half.point[1]) * half.towards[1];
  return beyond >= -tolerance * std::hypot(half.towards[0], half.towards[1]);
}

bool covers(const Extent& box, const Vector& place, double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (place[axis] < box.low[axis] - tolerance || place[axis] > box.high[axis] + tolerance) return false;
  return true;
}

bool covers(const PolygonShape& polygon, const Vector& place, double tolerance) {
  return polygon.covers(in_plane(place), tolerance);
}

}  // namespace

PolygonShape::PolygonShape(std::vector<plane::Ring> rings) : rings_(std::move(rings)) {
  std::vector<plane::RingTree> trees;
  for (const plane::Ring& ring : rings_) {
    if (ring.size() < 3) throw std::invalid_argument("a polygon needs at least 3 vertices");
    trees.emplace_back(ring, 0);
  }
  trees_ = std::make_shared<const std::vector<plane::RingTree>>(std::move(trees));
}

bool PolygonShape::covers(const plane::Point& point, double tolerance) const {
  bool inside = false;
  for (const plane::RingTree& ring : *trees_) {
    plane::NearestSide nearest{0, 0.0, tolerance * tolerance};
    if (ring.find_nearest(point, 0, ring.sides(), nearest)) return true;
    inside = inside != ring.surrounds(point);
  }
  return inside;
}

std::size_t MaterialField::region_at(const Vector& place) const {
  for (std::size_t k = regions.size(); k > 0; --k)
    if (std::visit([&](const auto& shape) { return covers(shape, place, tolerance); }, regions[k - 1].shape)) return k;
  return kBodyRegion;
}

std::string MaterialField::name_of(std::size_t region) const {
  return region == kBodyRegion ? "body" : regions[region - 1].name;
}

const Material* MaterialField::homogeneous() const {
  const Material* only = nullptr;
  for (std::size_t region = 0; region <= regions.size(); ++region) {
    if (!counts(region)) continue;
    if (region != kBodyRegion && regions[region - 1].thickness) return nullptr;
    const Material& material = material_of(region);
    if (only && !(*only == material)) return nullptr;
    if (!only) only = &material;
  }
  return only;
}

std::vector<std::array<plane::Point, 2>> borders(const MaterialField& field, const Extent& box) {
  std::vector<std::array<plane::Point, 2>> segments;
  for (const Region& region : field.regions)
    for (const std::array<plane::Point, 2>& side : sides_within(region.shape, box, field.tolerance))
      segments.push_back(side);
  return segments;
}

std::vector<std::array<plane::Point, 2>> borders_within(const MaterialField& field, const Body& body) {
  std::vector<std::array<plane::Point, 2>> within;
  for (const std::array<plane::Point, 2>& side : borders(field, extent_of(body))) {
    const plane::Point &p = side[0], &q = side[1];
    const std::vector<double> cuts = crossings(p, q, body.rings);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto at = [&](double t) { return plane::Point{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])}; };
      if (plane::contains(body, at(0.5 * (cuts[i] + cuts[i + 1])))) within.push_back({at(cuts[i]), at(cuts[i + 1])});
    }
  }
  return within;
}

std::array<std::vector<double>, 3> border_planes(const MaterialField& field, const Extent& box) {
  std::array<std::vector<double>, 3> planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> places;
    for (const Region& region : field.regions)
      if (const auto* one = std::get_if<Extent>(&region.shape)) {
        places.push_back(one->low[axis]);
        places.push_back(one->high[axis]);
      }
    std::ranges::sort(places);
    for (const double place : places)
      if (place > box.low[axis] + field.tolerance && place < box.high[axis] - field.tolerance &&
          (planes[axis].empty() || place > planes[axis].back() + field.tolerance))
        planes[axis].push_back(place);
  }
  return planes;
}

}  // namespace nodal::elastic
