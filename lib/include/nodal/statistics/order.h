// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Order statistics: quantiles and ranks.
///
/// Values   finite or +∞ ("never"); NaN is nobody's order, and a std::invalid_argument.
/// Cost     a sort.

#include <span>
#include <vector>

namespace nodal::statistics {

/// The p-quantile of at least one value, p in [0, 1], by linear interpolation between order statistics (Hyndman & Fan
/// 1996, type 7). +∞ where what it would be interpolated with is.
[[nodiscard]] double quantile(std::vector<double> values, double p);
/// The same of values that are in order.
[[nodiscard]] double quantile_of_sorted(std::span<const double> sorted, double p);

/// Ranks from 1, equal values sharing the mean of theirs (mid-ranks), in the values' order.
[[nodiscard]] std::vector<double> mid_ranks(std::span<const double> values);

/// Σ (t³ − t) over groups of t equal values: what ties take from the variance of rank statistics.
[[nodiscard]] double tie_term(std::span<const double> values);

}  // namespace nodal::statistics
