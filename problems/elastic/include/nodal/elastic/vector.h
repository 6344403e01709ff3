// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Positions, directions and displacements in the plane and in space, and which displacement is which number.
///
/// The dimension is a number, 2 or 3, wherever a net, its loads or its files are spoken of: positions have three
/// components always, the third of them 0 in the plane; what is indexed by freedom is a flat vector of `dimension`
/// numbers per node, and only `Freedoms` knows how.
///
/// Units    metres.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nodal::elastic {

/// A position, a direction or a displacement. In the plane the third component is 0.
using Vector = std::array<double, 3>;

[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Neither overflows nor underflows.
[[nodiscard]] inline double norm(const Vector& v) { return std::hypot(std::hypot(v[0], v[1]), v[2]); }
[[nodiscard]] inline double distance(const Vector& a, const Vector& b) { return norm(a - b); }

/// An upright box around positions.
struct Extent {
  Vector low{}, high{};

  [[nodiscard]] double along(std::size_t axis) const noexcept { return high[axis] - low[axis]; }
  /// The longest side: what tolerances of positions are relative to.
  [[nodiscard]] double size() const noexcept { return std::fmax(std::fmax(along(0), along(1)), along(2)); }
};

/// The smallest box; all zero around no position.
[[nodiscard]] Extent extent_of(const std::vector<Vector>& positions);

/// Which displacement is which number: the axes of a node after each other. The only place that multiplies by the
/// dimension.
struct Freedoms {
  std::size_t dimension = 2, nodes = 0;

  [[nodiscard]] constexpr std::size_t size() const noexcept { return dimension * nodes; }
  [[nodiscard]] constexpr std::size_t at(std::size_t node, std::size_t axis) const noexcept {
    return dimension * node + axis;
  }
  [[nodiscard]] constexpr std::size_t node_of(std::size_t freedom) const noexcept { return freedom / dimension; }
  [[nodiscard]] constexpr std::size_t axis_of(std::size_t freedom) const noexcept { return freedom % dimension; }
  /// A node's part of a flat vector, as a position: what it lacks is 0.
  template <class Flat>
  [[nodiscard]] constexpr Vector vector_at(const Flat& flat, std::size_t node) const {
    Vector v{};
    for (std::size_t axis = 0; axis < dimension; ++axis) v[axis] = flat[at(node, axis)];
    return v;
  }
};

/// "x", "y" and "z".
inline constexpr std::array<char, 3> kAxisNames = {'x', 'y', 'z'};

}  // namespace nodal::elastic
