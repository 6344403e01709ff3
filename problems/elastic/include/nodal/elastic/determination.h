// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which stiffnesses the data say anything about: a fit can look perfect while some of its springs are arbitrary.
///
/// Of the Jacobian J of the data's residuals in ln k, at given stiffnesses: a coordinate is undetermined when a
/// direction in the null space of J moves it. Then it can change by any factor, alone or with others, and to first
/// order no residual does. The null space is that of the singular values below 1e-9 of the largest: a change of ln k by
/// 1 that moves the displacements by so little is below what J itself is computed to, and below any measurement. A
/// prior is no measurement: what it alone decides is undetermined.
///
/// Cost     residuals × coordinates × the lesser of both; above kMostDeterminationWork, or with a Jacobian above
///          kMostJacobianWork, nothing but the numbers are compared.
/// Threads  a pure function.

#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/elastic_problem.h>

namespace nodal::elastic {

/// About half a second.
inline constexpr double kMostDeterminationWork = 3e7;
/// Residuals × springs: the Jacobian's own cost, whatever is tied.
inline constexpr double kMostJacobianWork = 1e7;

struct Determination {
  bool examined = false;     ///< false when J is too large, or there is no equilibrium here
  std::size_t measured = 0;  ///< residuals with a weight
  std::size_t coordinates = 0;
  std::size_t open = 0;  ///< dimension of the null space; what the numbers alone say where not examined
  std::vector<std::size_t> undetermined;  ///< coordinates, ascending
};

/// std::invalid_argument for a wrong number of stiffnesses. Of a problem without a reference nothing is asked.
[[nodiscard]] Determination determine(const ElasticProblem& problem, std::span<const double> stiffness);

/// "19 known displacements can't determine 24 stiffnesses: …", with the springs named; empty when all are
/// determined.
[[nodiscard]] std::string describe(const Determination& determination, const ElasticProblem& problem);

/// What would determine more stiffnesses where the data leave some open, at the start: fitting what is held out, tying
/// springs, a prior. A line each, with what stays open then. Empty when all are determined.
/// Cost     a determination for each.
[[nodiscard]] std::vector<std::string> propose(const ElasticProblem& problem);

}  // namespace nodal::elastic
