// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The body that is approximated: in the plane a polygon with holes, of constant thickness; in space an upright box.
///
/// Rings[0] is the outline, counterclockwise; the others are holes, clockwise: material lies to the left of every side.
/// A plane body without rings is one of which only nodes are known: it has no border, no area and no corners.
///
/// Units    metres, radians.
/// Threads  plain values.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/point.h>

namespace nodal::elastic {

/// A vertex is a corner where the outline turns by more than this, unless a study says otherwise.
inline constexpr double kDefaultCornerTurn = 30.0 / 180.0 * 3.14159265358979323846;

/// A node is on a side or at a corner within this share of the body's size, unless a study says otherwise
/// (`on_outline`): people write coordinates with six digits.
inline constexpr double kOnOutline = 1e-6;

/// Places and distances that agree within this share of a size differ by rounding alone.
inline constexpr double kPlaceRounding = 1e-9;

struct Body {
  std::string name = "";                  ///< for people: "rectangle 4 × 4", "gear.wkt"
  std::vector<plane::Ring> rings;         ///< [0] the outline, counterclockwise; then holes, clockwise
  std::vector<std::string> remarks = {};  ///< what was mended when it was read
  std::optional<Extent> box = {};         ///< the body in space, which has no rings
  double thickness = 1.0;                 ///< 1 in space
  double corner_turn = kDefaultCornerTurn;
  double on_outline = kOnOutline;  ///< share of the size within which a node is on the outline
  std::vector<bool> turned = {};   ///< [rings] given the other way round; empty where none was

  [[nodiscard]] std::size_t dimension() const noexcept { return box ? 3 : 2; }
  [[nodiscard]] bool has_outline() const noexcept { return !rings.empty(); }
  /// The side, from vertex i to the next, that whoever gave the ring calls `number`; both count from 0. A ring that was
  /// turned round kept its first vertex, so its sides run backwards.
  [[nodiscard]] std::size_t side(std::size_t ring, std::size_t number) const {
    return ring < turned.size() && turned[ring] ? rings[ring].size() - 1 - number : number;
  }
};

/// The smallest upright box around a body; all zero around one of which only nodes are known.
[[nodiscard]] Extent extent_of(const Body& body);

/// The distance within which a node is on the body's border: plane::outline_tolerance of it, and rounding in space,
/// where nodes are the grid's own.
[[nodiscard]] double border_tolerance(const Body& body);

namespace plane {

struct Box {
  Point low = {0.0, 0.0}, high = {0.0, 0.0};

  [[nodiscard]] double width() const noexcept { return high[0] - low[0]; }
  [[nodiscard]] double height() const noexcept { return high[1] - low[1]; }
  /// The larger of both: what tolerances of positions are relative to.
  [[nodiscard]] double size() const noexcept { return width() > height() ? width() : height(); }
};

/// The smallest box around points; all zero around none.
[[nodiscard]] Box bounding_box(const std::vector<Point>& points);

/// The distance within which a point is on the body's outline: `on_outline` of its size, but no more than a
/// twentieth of half a strip's width, area over perimeter, or every node of a thin strip would be. 0 without an
/// outline. One pass over the sides.
[[nodiscard]] double outline_tolerance(const Body& body);

/// ∫ 1, x, y, x², xy, y² dA.
struct Moments {
  double area = 0.0;
  Point first = {0.0, 0.0};
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Exact moments of a polygon with holes about `origin`, by Green's formula over its sides; coordinates are taken
/// relative to the middle of the bounding box while summing, so a body far from the origin loses no digits but those of
/// its coordinates. One pass over the sides.
[[nodiscard]] Moments moments(const std::vector<Ring>& rings, const Point& origin = {0.0, 0.0});

// Shapes. Refusal for sizes that are not positive, anything that is not finite, fewer than 3 sides, or a
// ring whose hole is not smaller than itself. The rectangle's sides begin at its lower left; a polygon of `sides` sides
// has its first vertex at (centre + radius, 0) turned by `turn`.
[[nodiscard]] Body rectangle_body(const Point& corner, const Point& size, double thickness = 1.0);
[[nodiscard]] Body regular_body(const Point& centre, double radius, std::size_t sides, double turn = 0.0,
                                double thickness = 1.0);
/// A disc as a polygon of `sides` sides inscribed in it.
[[nodiscard]] Body disc_body(const Point& centre, double radius, std::size_t sides, double thickness = 1.0);
[[nodiscard]] Body ring_body(const Point& centre, double radius, double hole, std::size_t sides,
                             double thickness = 1.0);

/// True inside the material or within the outline's tolerance of it. One pass over the sides; for many points there is
/// geometry/plane/outline.h.
[[nodiscard]] bool contains(const Body& body, const Point& point);

/// The vertices at which a ring turns by more than `turn`, by more than rounding (1e-6), ascending.
[[nodiscard]] std::vector<std::size_t> corner_vertices(const Ring& ring, double turn);

}  // namespace plane

namespace space {

/// The upright box from `corner` on, in space, metres. Refusal for sizes that are not positive, anything that is not
/// finite, sides below 1e-100 m, above 1e100 m or below 1e-6 of the longest, and a box so far from the origin that its
/// places are rounded by more than kPlaceRounding of its size.
[[nodiscard]] Body box_body(const Vector& corner, const Vector& size);

}  // namespace space

}  // namespace nodal::elastic
