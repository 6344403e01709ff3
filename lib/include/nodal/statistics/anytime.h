// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How good trials are at any time: surfaces of attainment and the area over a convergence curve.
///
/// A history is a trial's best quality so far: points of strictly rising cost and strictly falling quality, each
/// holding from its cost on. Before the first there is nothing: +∞. A trial that has ended keeps its best.
///
/// Sources  V. Grunert da Fonseca, C. M. Fonseca & A. O. Hall, "Inferential performance assessment of stochastic
///          optimisers and the attainment function", EMO 2001; M. López-Ibáñez, D. Vermetten, J. Dreo & C. Doerr,
///          "Using the empirical attainment function for analyzing single-objective black-box optimization algorithms",
///          IEEE Trans. Evol. Comput. 2025.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace nodal::statistics {

struct BestSoFar {
  double cost = 0.0, quality = 0.0;
};
using History = std::vector<BestSoFar>;

/// Best quality at a cost; +∞ before there is any.
[[nodiscard]] double quality_at(const History& history, double cost);

/// Share of the histories that have the quality, or better, at the cost: α(cost, quality). 0 for no histories.
[[nodiscard]] double attainment(std::span<const History> histories, double cost, double quality);

/// The surface attained by a share of at least `share` in (0, 1] of the histories: the best quality q(cost) with
/// α(cost, q) ≥ share, as a history. Without interpolation: some trial was there.
/// Cost     points of all, sorted.
[[nodiscard]] History attainment_surface(std::span<const History> histories, double share);
/// Those of several shares, in their order, for the cost of one.
[[nodiscard]] std::vector<History> attainment_surfaces(std::span<const History> histories,
                                                       std::span<const double> shares);

/// Where convergence is looked at: from cost to cost, gaps from `largest` down to `smallest`.
struct AnytimeLimits {
  double from = 0.0, to = 0.0;  ///< 0 < from < to
  double largest = 1.0, smallest = 1e-8;
};

/// Area over the convergence curve, of gaps, both axes in logarithms:
///
///     AOCC = 1 − 1/ln(to/from) ∫_from^to  clamp(ln(gap(c)/smallest) / ln(largest/smallest), 0, 1) d ln c
///
/// 1 for a trial that is at the smallest gap from the first cost on, 0 for one that never leaves the largest.
/// std::invalid_argument for limits that aren't in order.
[[nodiscard]] double area_over_convergence(const History& gaps, const AnytimeLimits& limits);

}  // namespace nodal::statistics
