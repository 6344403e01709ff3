// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points spread evenly by iterated Voronoi diagrams (Lloyd 1982; paper, Figure 2) in any polygon with holes.
///
/// One iteration: corners stay; a border point goes to the place of its own chain that is nearest to the centroid of
/// its cell; an inner point goes to the centroid. A step that would leave the body, or come too near to the outline or
/// to the next point on it, is shortened. No step goes away from the cell's centroid, so the energy
///   E = Σ_i ∫_{cell i} ρ |x − p_i|² dA
/// never rises: with the old cells it falls, since ∫ρ|x − p|² = ∫ρ|x − c|² + m |p − c|²; new cells are the best there
/// are for the new points.
///
/// Reported is E n' / (2 A ∫ρ). A point on the border has but part of a cell, so n' counts a point by the share of a
/// full turn about it that lies in the body: inner points 1, border points ½, corners angle/2π. Regular hexagons all
/// over the body have kHexagonalEnergy ≈ 0.0802, squares 1/12.
///
/// Units    metres; deviations are relative to the mean, moves to the even spacing.
/// Cost     per iteration n log n: 10,000 points take 13 ms, with a density spot 20 ms (micro/voronoi.cpp).
/// Errors   std::invalid_argument: no points; Refusal: points that (nearly) coincide; InputError in a build without
///          CGAL.

#include <cstddef>
#include <vector>

#include "geometry/plane/density.h"
#include "points/placement.h"

namespace nodal::elastic::plane {

/// The least energy of regions per point in the plane (Fejes Tóth): that of regular hexagons, 5/(36√3).
inline constexpr double kHexagonalEnergy = 0.080187537387448;

/// One line of the record of iterated Voronoi regions (paper, Figure 2); iteration 0 is the start. Deviations are
/// relative to the mean. Energies are E n'/(2 A ∫ρ), where n' counts a point by the share of a full turn about it that
/// lies in the body: regular hexagons all over it have kHexagonalEnergy, squares 1/12.
struct VoronoiStep {
  std::size_t iteration = 0;
  double distance_deviation = 0.0;  ///< standard deviation of neighbours' distances
  double area_deviation = 0.0;      ///< of regions' areas
  double energy = 0.0;              ///< of E = Σ_i ∫ ρ |x − p_i|² dA over the regions; never rises
  double inner_energy = 0.0;        ///< of the regions that don't meet the outline; 0 of none
  double area_error = 0.0;          ///< |sum of the regions' areas − A| / A
  double largest_move = 0.0;        ///< that led here, in even spacings
};

struct VoronoiOptions {
  std::size_t iterations = 50;  ///< at most
  double tolerance = 0.0;       ///< stops after an iteration whose largest move, in even spacings, is less; 0 never
  Density density = {};
};

struct IteratedVoronoi {
  PlacedPoints points;
  std::vector<VoronoiStep> history;
  std::vector<std::vector<Ring>> cells;  ///< [points]: the rings of each region in the body
};

[[nodiscard]] IteratedVoronoi iterate_voronoi(const Outline& outline, PlacedPoints start,
                                              const VoronoiOptions& options = {});

}  // namespace nodal::elastic::plane
