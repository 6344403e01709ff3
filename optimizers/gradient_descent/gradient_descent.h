// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plain gradient descent, the method that the 1995 paper rejects ("a pure gradient-descent delivered bad results"): a
/// step against the gradient. Its length is searched for, halved until the cost falls by enough (Armijo) and doubled
/// after one that did; or fixed, always the same multiple of the gradient, whatever becomes of the cost.
///
/// Against which gradient is the question: the direction of steepest descent depends on the variables. In the
/// coordinates x it is −∂f/∂x. In their exponentials y = e^x, stiffnesses where coordinates are their logarithms, it is
/// −∂f/∂y = −(∂f/∂x)/y: soft springs are moved far, in proportion to what they are, and stiff ones hardly. A step is
/// cut by the bounds, coordinate by coordinate (projected gradients).
///
/// Source   J. Nocedal, S. Wright, Numerical Optimization, chapters 3.1 and 16.7, 2006; section 5.5 of the paper.

#include <nodal/optimizer.h>

namespace nodal::gradient_descent {

enum class Variables { coordinates, exponentials };

struct Settings {
  Variables variables = Variables::coordinates;
  bool fixed = false;        ///< the multiple of the gradient is the first step's for good
  double first_step = 0.01;  ///< largest change of a variable: share of the widest side of the box, or of the largest
                             ///< exponential at the start
  int max_iterations = 1'000'000;
};

class GradientDescent final : public Optimizer {
 public:
  explicit GradientDescent(const Settings& settings) : settings_(settings) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  Settings settings_;
};

}  // namespace nodal::gradient_descent
