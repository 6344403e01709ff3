// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What several methods do over several problems: ranks, and how many problems each solves how fast.
///
/// Shapes   [problems][methods], every row of one length; std::invalid_argument otherwise. Smaller values are better;
///          +∞ is "never".
/// Sources  M. Friedman, J. Am. Stat. Assoc. 32 (1937); E. D. Dolan & J. J. Moré, Math. Program. 91 (2002); J. J. Moré
/// &
///          S. M. Wild, SIAM J. Optim. 20 (2009); N. Gould & J. Scott, ACM Trans. Math. Softw. 43 (2016), on what a
///          performance profile doesn't say.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nodal::statistics {

using Matrix = std::vector<std::vector<double>>;

struct Friedman {
  std::vector<double> ranks;  ///< [methods] mean over problems, 1 is best, ties share
  double chi_squared = 0.0;
  double p = 1.0;  ///< that methods who don't differ rank so differently; 1 where all are equal
};

/// With N problems, k methods, R_j the mean ranks and T = Σ(t³ − t) over ties within problems,
///
///     χ² = 12N/(k(k + 1)) [Σ R_j² − k(k + 1)²/4] / (1 − T/(N k(k² − 1))),   p by χ² with k − 1 degrees of freedom
///
/// Empty without a problem or with fewer than two methods.
[[nodiscard]] std::optional<Friedman> friedman(const Matrix& values);

/// Share of problems that method j solves within `factor` times the best method's cost: ρ_j(τ). A problem that nobody
/// solves counts for nobody. [methods][factors]; empty without a problem.
[[nodiscard]] Matrix performance_profile(const Matrix& costs, std::span<const double> factors);

/// Share of problems that method j solves at a cost of `at` or less. For comparisons of unlike problems divide the
/// costs by a unit of each, as Moré and Wild do by the n + 1 values of a simplex gradient. [methods][at].
[[nodiscard]] Matrix data_profile(const Matrix& costs, std::span<const double> at);

/// Two methods whose order in a performance profile hangs on whether a third is there: the profile ranks each against
/// the best of all, not one against the other.
struct ProfileWarning {
  std::size_t left_out = 0, first = 0, second = 0;  ///< methods
  double factor = 0.0;                              ///< where `first` is above `second` with all, below without one
};
/// The first found, by method left out, factor and pair; empty where the profile's orders hold.
[[nodiscard]] std::optional<ProfileWarning> unstable_order(const Matrix& costs, std::span<const double> factors);

}  // namespace nodal::statistics
