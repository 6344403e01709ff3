// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How long an edge of a mesh may be at a place: spacing · min(1, (d/reach)^β), d the distance from the nearest
/// singular place, β by how singular that is.
///
/// Displacements grow like r^λ from such a place. What a cell of size s there spoils elsewhere is of order s^{2λ}, and
/// the cells there are reach·(spacing/reach)^{1/(1−β)} long: with β = 1 − 2λ/3 they spoil spacing³, what quadratic
/// elements leave elsewhere. Corners have β = 1 − 2λ/5, spacing⁵: meshes are halved everywhere to see how errors fall,
/// and what is singular falls by 2^{2λ} alone, so it must be little from the first.
///
/// Cost     a place: the number of singular ones, and as many powers as there are different β.

#include <map>
#include <vector>

#include <nodal/elastic/point.h>

namespace nodal::elastic::finite_elements {

/// λ of a corner between free sides with an angle of material in (0, 2π): the smallest root in [1/2, 1] of
/// sin λω = −λ sin ω (M. Williams, J. Appl. Mech. 19, 1952); 1 up to half a turn.
[[nodiscard]] double corner_exponent(double angle);

/// λ where four quarters meet, of which every other one is `contrast` times as stiff: (4/π) atan(contrast^{-1/2}), the
/// one of a scalar potential. Displacements have nearly the same at 100 (0.127). It is taken for all places where three
/// sectors or more meet, whatever their angles: an assumption, on the side of care where theirs is larger.
[[nodiscard]] double crossing_exponent(double contrast);

class SizeField {
 public:
  SizeField(double spacing, double reach) : spacing_(spacing), reach_(reach) {}

  void grade(const plane::Point& place, double power) { places_[power].push_back(place); }
  /// Grades where a ring's corners turn inwards, those of polygons that stand for curves too.
  void grade_corners(const plane::Ring& ring);

  /// Places nearer than `least` count as that far: the size of what is asked for, or a cell around a singular place
  /// that is no vertex would be divided without end.
  [[nodiscard]] double at(double x, double y, double least = 0.0) const;

 private:
  double spacing_, reach_;
  std::map<double, std::vector<plane::Point>> places_;  // by power
};

}  // namespace nodal::elastic::finite_elements
