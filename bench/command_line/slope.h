// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a search that ended is at a minimum within the box, as the gradient sees it.

#include <optional>
#include <span>

#include <nodal/problem.h>

namespace nodal {

/// What a step of a thousandth of the box along every coordinate that isn't held by a bound still promises to first
/// order, as a share of the cost: Σ |g_i| min(10⁻³ width_i, room_i) / cost, with the room that is left downhill. 0
/// where √(2 cost) is below 1e-6, finer than anything is measured: relative to itself such a cost slopes
/// everywhere. Empty where the problem has no gradient, or can't be evaluated there.
///
/// Shapes   x: [coordinates].
/// Cost     one value and gradient of an evaluator of its own.
[[nodiscard]] std::optional<double> promised_share(const Problem& problem, std::span<const double> x);

/// Above this a point is no minimum: a tenth of a per mille for a step that small. Methods that have converged on
/// elastic plates leave 1e-6 and less, those that were stopped by their bounds 1e-2.
inline constexpr double kSlopeOfAMinimum = 1e-4;

}  // namespace nodal
