// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which material a body is of where: one everywhere, or one beside regions of others.
///
/// Regions come in order, and of those that cover a place the last wins. A region's border belongs to it, and so does
/// what is within `tolerance` of that border, so that rounding decides nothing. Of a body in the plane regions are half
/// planes, upright boxes and polygons; in space boxes.
///
/// Units    metres, Pa, kg/m³ (in the plane too).
/// Threads  plain values; polygons share what makes them fast, which is immutable.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nodal/elastic/body.h>
#include <nodal/elastic/material.h>
#include <nodal/elastic/point.h>

namespace nodal::elastic {

namespace plane {
class RingTree;
}

/// All beyond the line through `point` at right angles to `towards`, which has any length but 0.
struct HalfPlane {
  plane::Point point = {0.0, 0.0}, towards = {1.0, 0.0};
};

/// What an odd number of rings surrounds, whichever way they run: polygons with holes, one or several.
class PolygonShape {
 public:
  /// std::invalid_argument for a ring of fewer than 3 vertices.
  explicit PolygonShape(std::vector<plane::Ring> rings);

  [[nodiscard]] const std::vector<plane::Ring>& rings() const noexcept { return rings_; }
  /// In about log n.
  [[nodiscard]] bool covers(const plane::Point& point, double tolerance) const;

 private:
  std::vector<plane::Ring> rings_;
  std::shared_ptr<const std::vector<plane::RingTree>> trees_;
};

/// A box in the plane is flat: its z are 0.
using RegionShape = std::variant<HalfPlane, Extent, PolygonShape>;

struct Region {
  std::string name;
  RegionShape shape;
  Material material;
  std::optional<double> density = {};    ///< that of the body's masses where it has none
  std::optional<double> thickness = {};  ///< in the plane, where it isn't the body's
};

/// What regions say of the body itself.
inline constexpr std::size_t kBodyRegion = 0;

struct MaterialField {
  MaterialField() = default;
  /// The same everywhere. Implicit, since most bodies are of one material.
  MaterialField(const Material& everywhere) : base(everywhere) {}

  Material base;
  std::vector<Region> regions = {};
  double tolerance = 0.0;  ///< within which a place is on a region's border
  /// [1 + regions] of the body's area or volume, the body's own first; empty where nobody has asked.
  std::vector<double> shares = {};

  /// kBodyRegion, or k for regions[k − 1]; asks region by region, polygons in log n.
  [[nodiscard]] std::size_t region_at(const Vector& place) const;
  [[nodiscard]] const Material& material_of(std::size_t region) const {
    return region == kBodyRegion ? base : regions[region - 1].material;
  }
  [[nodiscard]] const Material& at(const Vector& place) const { return material_of(region_at(place)); }
  /// `of_body` where nothing else is said.
  [[nodiscard]] double thickness_of(std::size_t region, double of_body) const {
    return region == kBodyRegion ? of_body : regions[region - 1].thickness.value_or(of_body);
  }
  [[nodiscard]] double thickness_at(const Vector& place, double of_body) const {
    return regions.empty() ? of_body : thickness_of(region_at(place), of_body);
  }
  [[nodiscard]] double density_of(std::size_t region, double of_body) const {
    return region == kBodyRegion ? of_body : regions[region - 1].density.value_or(of_body);
  }
  /// "body", or the region's name.
  [[nodiscard]] std::string name_of(std::size_t region) const;
  /// It has a part of the body; all do where shares aren't known.
  [[nodiscard]] bool counts(std::size_t region) const { return shares.empty() || shares[region] > 0.0; }

  /// The one material of all that count, where they have the same constants and the body's thickness; else none.
  [[nodiscard]] const Material* homogeneous() const;
  [[nodiscard]] bool is_homogeneous() const { return homogeneous() != nullptr; }
};

/// The borders of the regions within a box around the body, as segments; in the plane. What runs along the box's own
/// border is left out, and what later regions hide is not.
[[nodiscard]] std::vector<std::array<plane::Point, 2>> borders(const MaterialField& field, const Extent& box);

/// The same within a body in the plane, with an outline.
[[nodiscard]] std::vector<std::array<plane::Point, 2>> borders_within(const MaterialField& field, const Body& body);

/// By axis the places of the faces of boxes that are inside a box around the body, ascending, each once; in space.
[[nodiscard]] std::array<std::vector<double>, 3> border_planes(const MaterialField& field, const Extent& box);

}  // namespace nodal::elastic
