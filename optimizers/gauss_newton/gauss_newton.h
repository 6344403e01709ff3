// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Gauss-Newton without a matrix: a trust region whose steps truncated conjugate gradients find.
///
/// Each iteration asks for the residuals once and for up to a hundred products with J and Jᵀ, and keeps some twenty
/// vectors: what it costs grows as the problem's own solves do, so it goes where a dense Jacobian can't.
///
/// The region is a box, `radius` times the width of the space's, cut by its bounds. It grows where the model holds at
/// its sides; where the cost doesn't fall, the step is taken shorter and the region with it.
///
/// The first steps stop their conjugate gradients early, so that long waves are fitted before short ones. Once a step
/// promises little, they go on for longer. Such a step hardly changes any coordinate, but all of them together
/// change the residuals by a smooth second-order term that can outweigh what the step gains. So where the model didn't
/// hold, a few conjugate gradients from the trial point take that term away before the step is judged (a second-order
/// correction). Without it the region would shrink around steps that are fine: on the 100 × 100 plate 40 conjugate
/// gradients per step were then slower than 10, with it they are faster (docs/performance.md).
///
/// Before the first step the start is moved by up to `jitter` in each coordinate, always the same way: where a start is
/// symmetric, the gradient is, too, and a better point that isn't is found by rounding only. On the 100 × 100 plate,
/// whose best springs are uneven, that nearly halves the time.
///
/// Source   J. Nocedal, S. Wright, Numerical Optimization, chapters 4, 7, 10 and 15.4 (second-order correction), 2006.

#include <nodal/optimizer.h>

#include "truncated_cg.h"

namespace nodal::gauss_newton {

struct Settings {
  double initial_radius = 0.2;  ///< share of the box
  double jitter = 0.01;         ///< share of the box; 0 begins at the start itself
  int max_iterations = 1000;
  double cost_tolerance = 1e-15;  ///< ends when a step promises less than this share of the cost
  CgLimits early = {10, 0.1};     ///< of a step's conjugate gradients, at first
  CgLimits late = {40, 0.02};     ///< from the first step on that promises less than 5 % of the cost
  int correction_iterations = 8;  ///< conjugate gradients of a second-order correction; 0 for none
  std::size_t pairs = 1;          ///< directions that precondition
};

class GaussNewton final : public Optimizer {
 public:
  explicit GaussNewton(const Settings& settings) : settings_(settings) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  Settings settings_;
};

}  // namespace nodal::gauss_newton
