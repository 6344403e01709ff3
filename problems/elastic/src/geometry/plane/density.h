// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How dense points shall be: ρ(x) = 1 + Σ_spots (factor − 1) exp(−|x − c|²/r²).
///
/// Integrals over a polygon go by Green's formula along its edges, like a polygon's area. The inner integral is closed
/// (∫ exp(−u²) u^k du, k = 0, 1, 2), the outer one is Gauss–Legendre on pieces short enough (r/2 with 6 nodes, r/8 with
/// 4) for an error of 1e-13 of the spot's own integral. Neighbouring cells thus share what they compute on a common
/// edge, and sums over cells are the body's to rounding.
///
/// Units    metres; factors are plain numbers.
/// Threads  immutable once built.

#include <vector>

#include <nodal/elastic/point.h>

namespace nodal::elastic::plane {

/// Near the centre there are `factor` times as many points per area as elsewhere (in the limit of many, Lloyd's
/// iteration gives √factor times).
struct DensitySpot {
  Point centre = {0.0, 0.0};
  double radius = 1.0;
  double factor = 1.0;
};

/// ∫ρ, ∫ρ(x − p), ∫ρ|x − p|² about a node p.
struct WeightedSums {
  double mass = 0.0;
  Point first = {0.0, 0.0};
  double second = 0.0;
};

class Density {
 public:
  Density() = default;
  /// Refusal for a radius or factor that is not positive, or spots below 1 that together push the density
  /// to zero somewhere.
  explicit Density(std::vector<DensitySpot> spots);

  [[nodiscard]] bool uniform() const noexcept { return spots_.empty(); }
  [[nodiscard]] double at(const Point& x) const;
  /// No place has more than this.
  [[nodiscard]] double bound() const;

  /// Adds what the spots contribute along the edge from node + a to node + b; the 1 is not among it.
  void add_edge(const Point& node, const Point& a, const Point& b, WeightedSums& sums) const;

 private:
  std::vector<DensitySpot> spots_;
};

}  // namespace nodal::elastic::plane
