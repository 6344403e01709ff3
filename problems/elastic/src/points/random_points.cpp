// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/random_points.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/plane/area_sampler.h"

namespace nodal::elastic::plane {

namespace {

// Draws per point, over all points, after which a density is given up: one in ten thousand kept takes a second for 10⁴.
constexpr std::size_t kDrawsPerPoint = 10000;

// The polygon that the border points make, ring by ring: what a triangulation of all points will fill.
Outline polygon_of(const Outline& outline, const PlacedPoints& border) {
  Body polygon;
  polygon.rings.resize(outline.rings());
  for (std::size_t i = 0; i < border.size(); ++i)
    polygon.rings[outline.chains()[border.places[i].chain].ring].push_back(border.points[i]);
  return Outline(polygon);
}

void add_inner(const Outline& outline, const RandomPointsOptions& options, RandomStream& random, PlacedPoints& made) {
  if (options.inner == 0) return;
  const AreaSampler area(outline);
  const Outline polygon = polygon_of(outline, made);
  const auto total = static_cast<double>(options.inner + options.border);
  const double keep = outline.clearance(even_spacing(outline.area(), total));
  const double bound = options.density.bound();
  const std::size_t most = kDrawsPerPoint * (options.inner + 10);
  std::size_t kept = 0;
  for (std::size_t draw = 0; kept < options.inner; ++draw) {
    if (draw == most)
      throw Refusal(
          fmt::format("the density is too uneven for random points, or the border points too few to follow the "
                      "outline: of {} draws "
                      "in the body {} were kept, {} are needed",
                      draw, kept, options.inner));
    const Point at = area.draw(random);
    if (!options.density.uniform() && random.uniform() * bound >= options.density.at(at)) continue;
    if (outline.distance(at, keep) < keep || !outline.surrounds(at)) continue;
    if (polygon.distance(at, keep) < keep || !polygon.surrounds(at)) continue;
    made.add(at);
    ++kept;
  }
}

}  // namespace

RandomPointsOptions share_points(const Outline& outline, std::size_t total) {
  const std::size_t least = least_border_points(outline);
  if (total < least)
    throw Refusal(fmt::format(
        "{} points are too few: every corner of the outline needs one and every ring 3, {} in all", total, least));
  const double spacing = even_spacing(outline.area(), static_cast<double>(total));
  const double wanted = std::min(std::round(outline.perimeter() / spacing), static_cast<double>(total));
  RandomPointsOptions options;
  options.border = std::max(least, static_cast<std::size_t>(wanted));
  options.inner = total - options.border;
  return options;
}

PlacedPoints make_random_points(const Outline& outline, const RandomPointsOptions& options, RandomStream& random) {
  PlacedPoints made = make_border_points(outline, border_gaps(outline, options.border), options.spread, random);
  add_inner(outline, options, random, made);
  return made;
}

}  // namespace nodal::elastic::plane
