// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Order statistics: quantiles and ranks.
///
/// Values   finite or +∞ ("never"); NaN is nobody's order, and a std::invalid_argument.
/// Cost     a sort.

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace nodal::statistics {

/// The p-quantile of at least one value, p in [0, 1], by linear interpolation between order statistics (Hyndman & Fan
/// 1996, type 7). +∞ where what it would be interpolated with is.
[[nodiscard]] double quantile(std::vector<double> values, double p);
/// The same of values that are in order.
[[nodiscard]] double quantile_of_sorted(std::span<const double> sorted, double p);

/// An interval that holds the median of what the values are drawn from, whatever its distribution: order statistics
/// [x_(j), x_(n+1−j)] with the largest j for which P(Bin(n, ½) < j) ≤ (1 − confidence)/2 (W. J. Conover, Practical
/// Nonparametric Statistics, 1999, 3.2). Empty where there is none: below six values at 95 %.
[[nodiscard]] std::optional<std::pair<double, double>> median_interval(std::vector<double> values,
                                                                       double confidence = 0.95);

/// Ranks from 1, equal values sharing the mean of theirs (mid-ranks), in the values' order.
[[nodiscard]] std::vector<double> mid_ranks(std::span<const double> values);

/// Σ (t³ − t) over groups of t equal values: what ties take from the variance of rank statistics.
[[nodiscard]] double tie_term(std::span<const double> values);

}  // namespace nodal::statistics
