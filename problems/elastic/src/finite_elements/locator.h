// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which cell of a mesh, and of the meshes refined from it, a place is in.
///
/// Cost     to build: linear in the cells of the coarsest mesh. A place: some 1 µs there, by a grid of buckets (more
///          where small cells crowd), and then as much per refinement, from a cell to the best of its children.
/// Threads  immutable once built; the mesh must outlive it.

#include <array>
#include <cstddef>
#include <vector>

#include "finite_elements/mesh.h"

namespace nodal::elastic::finite_elements {

struct Location {
  std::size_t cell = 0;
  Barycentric weights{};  ///< negative ones where the place is outside of the cell
};

/// λ of a place in a cell.
[[nodiscard]] Barycentric barycentric(const Mesh& mesh, std::size_t cell, const Vector& place);

class Locator {
 public:
  explicit Locator(const Mesh& mesh);

  /// The cell that a place is in; of none, for a place that rounding or a rounded outline leaves outside, the nearest:
  /// the one with the smallest `distance`.
  [[nodiscard]] Location locate(const Vector& place) const;
  /// How far outside of its cell a location is, at least, and 0 inside: the largest distance to a side's plane.
  [[nodiscard]] static double distance(const Mesh& mesh, const Location& location);

 private:
  struct Found {
    Location location;
    double distance;
  };
  [[nodiscard]] std::array<std::size_t, 3> buckets_at(const Vector& place) const;
  template <class Visit>
  void for_each_bucket(const std::array<std::size_t, 3>& low, const std::array<std::size_t, 3>& high,
                       Visit visit) const;
  [[nodiscard]] Found nearest_among(const std::array<std::size_t, 3>& low, const std::array<std::size_t, 3>& high,
                                    const Vector& place) const;

  const Mesh& mesh_;
  Extent extent_;
  std::array<std::size_t, 3> counts_{1, 1, 1};
  std::vector<std::size_t> begins_, members_;  // cells by bucket
};

/// Of a location in a mesh, the one in `refined(mesh)`.
[[nodiscard]] Location descended(const Mesh& refined_mesh, const Location& location, const Vector& place);

/// Σ_k N_k(λ) u_k over the nodes of a location's cell; `values` are [nodes][mesh.dimension].
[[nodiscard]] Vector interpolated(const Mesh& mesh, const Location& location, const std::vector<double>& values);

}  // namespace nodal::elastic::finite_elements
