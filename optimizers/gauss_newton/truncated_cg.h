// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One step within a trust region: conjugate gradients on the linear model of the residuals, stopped early.
///
///   min ½|r + J p|²  subject to  lower_i ≤ p_i ≤ upper_i
/// by products with J and Jᵀ alone. The box is the trust region in the largest norm, cut by the bounds of the space.
/// Coordinates that run into its sides are fixed there, all at once, and the iteration begins anew in the others. It
/// stops after j steps where going on gains little: j (m_{j−1} − m_j) ≤ tolerance · (m_0 − m_j).
/// The model falls with every step, so the result descends wherever the iteration stopped. Stopping early is also what
/// keeps the fit smooth: directions that hardly move the residuals come last, and aren't taken.
///
/// Source   T. Steihaug, SIAM J. Numer. Anal. 20, 1983; S. Nash, A. Sofer, Operations Research Letters 9, 1990.

#include <span>
#include <vector>

#include <nodal/meter.h>

#include "curvature_pairs.h"

namespace nodal::gauss_newton {

/// When a step's conjugate gradients stop.
struct CgLimits {
  int max_iterations;  ///< two products each
  double tolerance;    ///< of the last gain against the mean one, as above
};

/// Where p may lie.
struct Box {
  std::vector<double> lower, upper;
};

struct Step {
  std::vector<double> p;          ///< [coordinates]
  std::vector<double> residuals;  ///< r + J p
  int iterations = 0;
  bool at_side = false;  ///< some coordinate was stopped by the box
};

class TruncatedCg {
 public:
  /// `pairs`: directions of earlier steps that precondition (curvature_pairs.h).
  TruncatedCg(Meter& meter, std::size_t pairs);

  /// From p = 0 at the meter's last point, where `gradient` is Jᵀr. Another status than ok: a product failed or the
  /// budget is spent; the step is as good as it was by then.
  [[nodiscard]] Status solve(std::span<const double> residuals, std::span<const double> gradient, const Box& box,
                             const CgLimits& limits, Step& step);

 private:
  void begin(std::span<const double> residuals, std::span<const double> gradient, const Box& box, Step& step);
  [[nodiscard]] Status turn();
  [[nodiscard]] bool fits(const Box& box, const Step& step) const;
  [[nodiscard]] Status stop_at_sides(const Box& box, Step& step);
  [[nodiscard]] Status renew_gradient(const Step& step, bool remember);

  Meter& meter_;
  CurvaturePairs seen_, used_;  // collected for the next solve; in use during this one
  std::vector<double> gradient_, last_gradient_, free_gradient_;
  std::vector<double> scaled_, d_, jd_, change_, j_change_;
  std::vector<char> fixed_;
  double slope_ = 0.0;   // gradient · preconditioned gradient; 0 before the first direction
  double length_ = 0.0;  // along d to the model's lowest point; 0 where it is flat
};

}  // namespace nodal::gauss_newton
