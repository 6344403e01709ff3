// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/placement.h"

#include <cmath>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::plane {

Placement find_place(const Outline& outline, const Point& point) {
  if (outline.distance(point, 2.0 * outline.tolerance()) > outline.tolerance()) return {};
  const OutlinePlace at = outline.nearest(point);
  const Chain& chain = outline.chains()[at.chain];
  if (chain.closed) return {NodeKind::border, at.chain, at.arc};
  if (at.arc - chain.begin <= outline.tolerance()) return {NodeKind::corner, at.chain, chain.begin};
  if (chain.end - at.arc > outline.tolerance()) return {NodeKind::border, at.chain, at.arc};
  // At the end of a chain: the corner where the next of its ring begins.
  const std::size_t first = outline.first_chain(chain.ring), count = outline.corners(chain.ring);
  const std::size_t next = first + (at.chain - first + 1) % count;
  return {NodeKind::corner, next, outline.chains()[next].begin};
}

PlacedPoints place_points(const Outline& outline, std::vector<Point> points) {
  PlacedPoints placed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !outline.contains(p))
      throw Refusal(fmt::format("point {} at ({}, {}) is outside of the body", i, p[0], p[1]));
    placed.places.push_back(find_place(outline, p));
  }
  placed.points = std::move(points);
  return placed;
}

}  // namespace nodal::elastic::plane
