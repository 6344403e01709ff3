// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is at rest while a mechanism moves: a free body's motions are told relative to its largest rigid part.
///
/// Parts that turn as one are found by what determines a rigid motion: the two ends of a spring in the plane, the
/// corners of a triangle of springs in space. In a motion chosen at random they move as one rigid body only if they are
/// one.

#include <cstddef>
#include <vector>

#include "rigidity/rigidity.h"

namespace nodal::elastic {

using Motion = std::vector<double>;  ///< [dimension · nodes]

/// u(X) = shift + turn × X, X about the middle of the nodes, in shares of their size. In the plane only turn[2] isn't
/// 0.
struct RigidMotion {
  Vector shift{}, turn{};
};

class RestFrame {
 public:
  /// Finds the largest part (of equal ones that with the lowest spring or triangle) in a random motion that leaves the
  /// springs' lengths. Without any, the first node is what is at rest.
  RestFrame(const Structure& structure, const Motion& random);

  /// Takes the part's rigid motion out of u.
  void bring_to_rest(Motion& u) const;

 private:
  using Corners = std::vector<std::size_t>;  // of a spring, or a triangle; one node without any

  [[nodiscard]] Vector place(std::size_t node) const;
  [[nodiscard]] RigidMotion motion_of(const Corners& corners, const Motion& u) const;
  [[nodiscard]] RigidMotion motion_of_spring(const Corners& ends, const Motion& u) const;
  [[nodiscard]] RigidMotion motion_of_triangle(const Corners& corners, const Motion& u) const;

  const Structure& structure_;
  Freedoms freedoms_;
  Vector middle_{};
  double size_ = 1.0;
  Corners at_rest_ = {0};
};

/// How many rigid motions a free structure has: in the plane 3, or 2 of a single node; in space 6, 5 where all nodes
/// lie on a line, 3 of a single one.
[[nodiscard]] std::size_t rigid_motions_of(const Structure& structure);

}  // namespace nodal::elastic
