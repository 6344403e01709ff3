// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether two methods differ, and by how much: tests by ranks, which ask nothing of how results are distributed.
///
/// Values   any, +∞ for "never" included; p are two-sided.
/// Cost     a sort.
/// Sources  H. B. Mann & D. R. Whitney, Ann. Math. Stat. 18 (1947); F. Wilcoxon, Biometrics 1 (1945); S. Holm, Scand.
/// J.
///          Stat. 6 (1979); A. Vargha & H. D. Delaney, J. Educ. Behav. Stat. 25 (2000).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace nodal::statistics {

/// Â = P(X > Y) + ½ P(X = Y) over all pairs: ½ where neither tends to be larger. Empty where either is.
[[nodiscard]] std::optional<double> vargha_delaney(std::span<const double> x, std::span<const double> y);

struct RankTest {
  double statistic = 0.0;
  double p = 1.0;
};

/// Mann and Whitney's U of independent samples: pairs with x > y, ties as halves. With n = n_x + n_y and T = Σ(t³ − t)
/// over ties,
///
///     z = (|U − n_x n_y/2| − ½) / √(n_x n_y [n + 1 − T/(n(n − 1))]/12),   p = 2(1 − Φ(z)), at most 1
///
/// Equal samples have p = 1. Empty where either is. The normal approximation is fair from about 8 values each.
[[nodiscard]] std::optional<RankTest> mann_whitney(std::span<const double> x, std::span<const double> y);

enum class Exactness { where_possible, never };
inline constexpr std::size_t kMostExactPairs = 25;

/// Wilcoxon's signed ranks of pairs (two methods from the same starts): W, the smaller of the rank sums of positive and
/// negative differences x − y; pairs without a difference are left out (two infinite values have none). For at most
/// kMostExactPairs of them without ties p is exact, from the distribution of W over all 2^n signs; else, with T over
/// ties,
///
///     z = (W − n(n + 1)/4) / √(n(n + 1)(2n + 1)/24 − T/48),   p = 2Φ(z)
///
/// Empty without a pair, p = 1 without a difference; std::invalid_argument for lists of different lengths.
[[nodiscard]] std::optional<RankTest> wilcoxon(std::span<const double> x, std::span<const double> y,
                                               Exactness exactness = Exactness::where_possible);

/// Holm's step-down adjustment of m tests at once: with p_(1) ≤ … ≤ p_(m), adjusted p_(i) = max over j ≤ i of
/// (m − j + 1) p_(j), at most 1. In the order given.
[[nodiscard]] std::vector<double> holm(std::span<const double> p);

}  // namespace nodal::statistics
