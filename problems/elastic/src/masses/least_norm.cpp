// SPDX-License-Identifier: GPL-3.0-or-later
#include "moment_system.h"

namespace nodal::elastic {

Masses least_norm_masses(const std::vector<plane::Point>& points, const MassTarget& target) {
  const MomentSystem system(points, target);
  // m = U Σ⁻¹ Vᵀ p is of least norm, and so is every correction; two of them bring the last digits. Moments that the
  // nodes' others determine give way to those, so that mass and first moments are the body's wherever they can be.
  const Eigen::VectorXd wanted = system.consistent() ? system.target : system.attainable();
  Eigen::VectorXd masses = system.orthonormal * system.reduced(wanted);
  for (int step = 0; step < 2; ++step) masses += system.orthonormal * system.reduced(system.residual(wanted, masses));
  Masses made = system.result(masses);
  if (made.outcome != MassOutcome::found && !system.consistent()) {
    // q = −N Nᵀp vanishes on the nodes, and the body's moments make −‖Nᵀp‖² of it.
    const Eigen::VectorXd q = -system.undetermined * (system.undetermined.transpose() * system.target);
    made.certificate = system.certificate(q, Eigen::VectorXd::Zero(masses.size()));
    if (made.certificate) made.outcome = MassOutcome::infeasible;
  }
  made.message = describe(made);
  return made;
}

}  // namespace nodal::elastic
