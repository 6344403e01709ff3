// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points placed in a body, and where on its outline those are that lie on it.
///
/// Units    metres.
/// Threads  plain values.

#include <cstddef>
#include <vector>

#include <nodal/elastic/net.h>

#include "geometry/plane/outline.h"

namespace nodal::elastic::plane {

/// Border points know their chain and the arc on its ring; a corner's chain is the one that begins there.
struct Placement {
  NodeKind kind = NodeKind::inner;
  std::size_t chain = 0;
  double arc = 0.0;

  bool operator==(const Placement&) const = default;
};

struct PlacedPoints {
  std::vector<Point> points;
  std::vector<Placement> places;  ///< [points]

  [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
  void add(const Point& point, const Placement& place = {}) {
    points.push_back(point);
    places.push_back(place);
  }
};

/// Where a point of the body lies: a corner or the border within the outline's tolerance of it, else inner.
[[nodiscard]] Placement find_place(const Outline& outline, const Point& point);

/// The places of given points. Refusal for one outside of the body, naming it.
[[nodiscard]] PlacedPoints place_points(const Outline& outline, std::vector<Point> points);

}  // namespace nodal::elastic::plane
