// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The border of a body as curves: each ring is a closed curve measured by its length ("arc"), split at its corners
/// into chains, along which border nodes may slide.
///
/// A ring's arc is 0 at its first corner and grows in the ring's own sense, so that material is to the left; a ring
/// without corners is one closed chain whose arc is 0 at its first vertex. A ring with corners has as many chains, and
/// the k-th begins at the k-th corner.
///
/// Units    metres, radians.
/// Cost     n log n in the number of sides to build; nearest places and inside tests take about log n.
/// Threads  immutable once built.

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <nodal/elastic/body.h>

#include "geometry/plane/ring_tree.h"

namespace nodal::elastic::plane {

struct Chain {
  std::size_t ring = 0;
  double begin = 0.0, end = 0.0;  ///< arcs on the ring
  bool closed = false;            ///< a whole ring without corners: its ends are one place, and no corner
  double angle = 0.0;  ///< of material at the corner where it begins, in (0, 2π); half a turn where it is closed
  std::size_t first_side = 0, last_side = 0;  ///< from the ring's start; last is one beyond

  [[nodiscard]] double length() const noexcept { return end - begin; }
};

/// A place on the outline.
struct OutlinePlace {
  std::size_t chain = 0;
  double arc = 0.0;  ///< on the chain's ring
  Point point = {0.0, 0.0};
  double distance = 0.0;  ///< from the point that was asked about
};

class Outline {
 public:
  /// std::invalid_argument for a body without rings, or a ring of fewer than 3 vertices. The rings are taken as valid:
  /// simple, disjoint, the outline counterclockwise and holes clockwise.
  explicit Outline(const Body& body);

  [[nodiscard]] const std::vector<Chain>& chains() const noexcept { return chains_; }
  [[nodiscard]] std::size_t rings() const noexcept { return rings_.size(); }
  /// How many corners a ring has; its chains are chains()[first_chain(ring)] and on, at least one.
  [[nodiscard]] std::size_t corners(std::size_t ring) const noexcept { return corners_[ring]; }
  [[nodiscard]] std::size_t first_chain(std::size_t ring) const noexcept { return first_chain_[ring]; }
  /// Of all rings together.
  [[nodiscard]] double perimeter() const noexcept { return perimeter_; }
  [[nodiscard]] double area() const noexcept { return area_; }
  [[nodiscard]] const Box& box() const noexcept { return box_; }
  /// Within this distance a point counts as on the outline: outline_tolerance of the body.
  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
  [[nodiscard]] const RingTree& ring(std::size_t ring) const { return rings_[ring]; }

  /// The point at an arc of a ring; arcs beyond its length go round.
  [[nodiscard]] Point at(std::size_t ring, double arc) const;

  /// The nearest place of a chain to a point.
  [[nodiscard]] OutlinePlace nearest_on(std::size_t chain, const Point& point) const;
  /// The nearest place of all.
  [[nodiscard]] OutlinePlace nearest(const Point& point) const;
  /// The distance to the nearest place, or `beyond` where that is nearer: a small `beyond` answers fast.
  [[nodiscard]] double distance(const Point& point, double beyond = std::numeric_limits<double>::infinity()) const;

  /// Inside the material; a point on the outline may be told either way.
  [[nodiscard]] bool surrounds(const Point& point) const;
  /// Inside the material or within the tolerance of the outline.
  [[nodiscard]] bool contains(const Point& point) const;
  /// All of the segment p–q is contained.
  [[nodiscard]] bool covers(const Point& p, const Point& q) const;

  /// The distance that random and moving inner nodes keep from the outline: a hundredth of the spacing, or of half a
  /// strip's width where that is less; twice the tolerance at least, so that none is taken for a border node.
  [[nodiscard]] double clearance(double spacing) const;

 private:
  [[nodiscard]] std::size_t chain_of(std::size_t ring, std::size_t side) const;
  [[nodiscard]] OutlinePlace place_at(std::size_t ring, std::size_t chain, const NearestSide& side) const;

  Box box_;
  std::vector<RingTree> rings_;
  std::vector<Chain> chains_;
  std::vector<std::size_t> corners_, first_chain_;  // [rings]
  double perimeter_ = 0.0, area_ = 0.0, tolerance_ = 0.0;
};

/// How far apart n evenly spread points are in an area: the side of the equilateral triangles of a lattice with as
/// many.
[[nodiscard]] double even_spacing(double area, double count);

}  // namespace nodal::elastic::plane
