// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// min ‖G s − b‖ subject to s ≥ 0 for a G of few rows and many columns.
///
/// Source   C. Lawson, R. Hanson, Solving Least Squares Problems, 1974, chapter 23.
/// Cost     rows × columns per step; the passive set never exceeds the number of rows.

#include <Eigen/Core>

namespace nodal::elastic {

struct NonnegativeSolution {
  Eigen::VectorXd s;
  Eigen::VectorXd residual;  ///< b − G s: at the optimum Gᵀ residual ≤ 0, and residual · G s = 0
  bool settled = false;      ///< false when the steps ran out
};

[[nodiscard]] NonnegativeSolution nonnegative_least_squares(const Eigen::MatrixXd& g, const Eigen::VectorXd& b);

}  // namespace nodal::elastic
