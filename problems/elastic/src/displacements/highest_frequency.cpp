// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/highest_frequency.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <nodal/random.h>

namespace nodal::elastic {

namespace {

// M^-½ K M^-½ x by springs: K = Σ k_e b_e b_eᵀ.
Eigen::VectorXd applied(const Net& net, std::span<const double> stiffness, const Eigen::VectorXd& x) {
  const Freedoms freedoms = net.freedoms();
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    const Spring& s = net.springs[e];
    const double first = 1.0 / std::sqrt(net.masses[s.first]), second = 1.0 / std::sqrt(net.masses[s.second]);
    const double pull = stiffness[e] * (second * dot(s.direction, freedoms.vector_at(x, s.second)) -
                                        first * dot(s.direction, freedoms.vector_at(x, s.first)));
    for (std::size_t axis = 0; axis < net.dimension; ++axis) {
      y[static_cast<Eigen::Index>(freedoms.at(s.first, axis))] -= first * pull * s.direction[axis];
      y[static_cast<Eigen::Index>(freedoms.at(s.second, axis))] += second * pull * s.direction[axis];
    }
  }
  return y;
}

Eigen::VectorXd random_direction(Eigen::Index size) {
  RandomStream random(1);
  Eigen::VectorXd x(size);
  for (double& entry : x) entry = random.uniform(-1.0, 1.0);
  return x.normalized();
}

}  // namespace

double highest_frequency_estimate(const Net& net, std::span<const double> stiffness, std::size_t steps) {
  const auto size = static_cast<Eigen::Index>(net.freedoms().size());
  const Eigen::Index count = std::min(size, static_cast<Eigen::Index>(steps));
  Eigen::MatrixXd basis(size, count);
  Eigen::VectorXd diagonal(count), beside(count);
  basis.col(0) = random_direction(size);
  Eigen::Index done = 0;
  while (done < count) {
    Eigen::VectorXd next = applied(net, stiffness, basis.col(done));
    const double length = next.norm();
    diagonal[done] = basis.col(done).dot(next);
    ++done;
    for (int twice = 0; twice < 2; ++twice) next -= basis.leftCols(done) * (basis.leftCols(done).transpose() * next);
    beside[done - 1] = next.norm();
    if (done == count || !(beside[done - 1] > 1e-12 * length)) break;  // an invariant subspace: there is no more
    basis.col(done) = next / beside[done - 1];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
  ritz.computeFromTridiagonal(diagonal.head(done), beside.head(done - 1), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(ritz.eigenvalues().maxCoeff(), 0.0));
}

}  // namespace nodal::elastic
