// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Ceres' line-search minimizers of a cost with a gradient: L-BFGS, BFGS, nonlinear conjugate gradients.
///
/// They know no bounds. So they walk in y, unbounded, with x_i = middle_i + half_i · sin(y_i / half_i), half_i half the
/// width of the box: the box is never left, and a minimum on its border is one like any other.
/// Refusing points outside instead lets the line search stall at active bounds (bench plate, ν = 0.2: G = 2.3226 where
/// 2.3209 can be reached; and 13 instead of 0.7376 at ν = 0.3 with a large first step).
///
/// They see the cost scaled to begin near `first_cost`: an update of the Hessian is dropped when y·s ≤ 1e-14,
/// absolutely, which on a small cost is nearly always (same plate, ν = 0.3: 1,257 evaluations to G = 0.737626 unscaled,
/// 95 scaled).

#include <nodal/options.h>

#include "library.h"

namespace nodal::ceres_methods {

enum class Direction { lbfgs, bfgs, conjugate_gradient };

struct LineSearchSettings {
  Direction direction = Direction::lbfgs;
  std::string conjugate_gradient = "polak-ribiere";  ///< or "fletcher-reeves", "hestenes-stiefel"
  int max_iterations = 10000;
  int rank = 20;              ///< pairs of steps and gradients that L-BFGS remembers
  double first_cost = 100.0;  ///< 0 leaves the cost as it is
  Tolerances tolerances;      ///< the gradient's in units of the cost at the start
};

class LineSearchOptimizer final : public Optimizer {
 public:
  explicit LineSearchOptimizer(LineSearchSettings settings) : settings_(std::move(settings)) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  LineSearchSettings settings_;
};

}  // namespace nodal::ceres_methods
