// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes of a polygon with holes, by CGAL: constrained Delaunay triangulations, refined until no angle is below 20.6°
/// (but where the polygon itself or the interfaces are sharper) and no triangle longer than the size wanted there.
///
/// cgal_mesh.cpp does the work; a build without CGAL compiles absent_mesh.cpp instead, where plane_mesh throws
/// InputError with what to install. Same input, same mesh.
///
/// Units    metres.
/// Errors   Refusal for a mesh of more than `cell_limit` triangles, with where they are crowded.
/// Cost     some 6 µs per triangle, more with hundreds of singular places.

#include <cstddef>
#include <functional>
#include <vector>

#include <nodal/elastic/body.h>
#include <nodal/elastic/point.h>

#include "finite_elements/mesh.h"

namespace nodal::elastic::finite_elements {

/// A closed polygon: the outline counterclockwise, holes clockwise. Every vertex becomes a vertex of the mesh, and
/// side k, from vertex k to the next, gives its label to the mesh's sides on it.
struct LabelledRing {
  plane::Ring points;
  std::vector<std::size_t> labels;  ///< [points]
};

struct Segment {
  plane::Point first{}, second{};
};

struct PlaneBody {
  std::vector<LabelledRing> rings;  ///< [0] the outline; simple and disjoint
  /// What cells must not cross: they may cross the rings and each other, leave the body, lie on its sides and repeat
  /// each other. Within `tolerance` of a vertex they are moved there, and along a ring's side left out.
  std::vector<Segment> interfaces = {};
  std::vector<plane::Point> vertices = {};                ///< further places, inside the body, that must be vertices
  std::function<std::size_t(const Vector&)> region = {};  ///< of a cell's centre; 0 everywhere without it
  /// Where the solution is singular for other reasons than a corner that turns inwards: ends of supports,
  /// singular_interface_places, and corners where a traction along one side isn't met by the same shear on the other.
  std::vector<plane::Point> graded = {};
  /// Where the solution is more singular than at those, like d^λ: interface_crossings.
  std::vector<plane::Point> crossings = {};
  double crossing_exponent = 0.5;  ///< λ there; see size_field.h
  double tolerance = 0.0;          ///< of interfaces; 0: 1e-6 of the body's size
  std::size_t cell_limit = 1'000'000;
};

/// An edge may be spacing · min(1, (d/R)^β) long, d the distance of its triangle from the nearest singular place,
/// R = kGradingReach of the body's size. β is kGrading at places of `graded`, enough for displacements that grow like
/// d^λ with any λ > 1/2, and by itself less at every corner that turns inwards, by its angle (size_field.h).
inline constexpr double kGrading = 0.7;
inline constexpr double kGradingReach = 0.25;

[[nodiscard]] Mesh plane_mesh(const PlaneBody& body, double spacing);

/// Where interfaces make singular places, for `graded`: where one meets the border or another one, ends within the
/// body, or turns by more than `turn`. Needs no CGAL.
[[nodiscard]] std::vector<plane::Point> singular_interface_places(const PlaneBody& body,
                                                                  double turn = kDefaultCornerTurn);

/// Those among them where three sectors or more meet, inside or at the border: with stiffnesses far apart these have
/// the least exponents of all. Needs no CGAL.
[[nodiscard]] std::vector<plane::Point> interface_crossings(const PlaneBody& body);

/// Whether this build can.
[[nodiscard]] bool plane_meshes_available() noexcept;

}  // namespace nodal::elastic::finite_elements
