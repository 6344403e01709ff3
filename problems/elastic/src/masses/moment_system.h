// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A m = p in scaled coordinates and relative masses, with the decomposition A = V Σ Uᵀ of rank r that both forms of
/// masses stand on. Rows of Uᵀ are orthonormal, so whatever is computed in terms of them is well conditioned.

#include <vector>

#include <Eigen/Core>

#include "masses.h"

namespace nodal::elastic {

class MomentSystem {
 public:
  MomentSystem(const std::vector<plane::Point>& points, const MassTarget& target);

  double mass = 0.0;             ///< of the body; masses below are shares of it
  plane::Point middle, scale;    ///< of the nodes' box: its centre and half extents
  Eigen::MatrixXd rows;          ///< A: 6 × n
  Eigen::VectorXd target;        ///< p: 6
  std::size_t rank = 0;          ///< r
  Eigen::MatrixXd orthonormal;   ///< U: n × r
  Eigen::MatrixXd to_moments;    ///< V: 6 × r
  Eigen::VectorXd singular;      ///< Σ: r
  Eigen::MatrixXd undetermined;  ///< 6 × (6 − r): combinations of rows that vanish on all nodes

  /// The same combinations, solved each for the moment that it determines, second moments first: conditions · A = 0,
  /// conditions(c, determined[c]) = 1.
  Eigen::MatrixXd conditions;
  std::vector<Eigen::Index> determined;

  /// p − A m, summed in extended precision.
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& masses) const { return residual(target, masses); }
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& wanted, const Eigen::VectorXd& masses) const;
  /// Σ⁻¹ Vᵀ: from moments to the coordinates of Uᵀ m.
  [[nodiscard]] Eigen::VectorXd reduced(const Eigen::VectorXd& moments) const;
  /// The part of p that no masses can meet is within rounding.
  [[nodiscard]] bool consistent() const;
  /// p with the determined moments as the others imply them: what the nodes can meet.
  [[nodiscard]] Eigen::VectorXd attainable() const;
  [[nodiscard]] std::vector<FailingCondition> failing() const;
  /// Coefficients y as a certificate against masses above `lower`, made nonnegative on the nodes by the row of ones;
  /// nothing when the sum doesn't come out negative by more than rounding.
  [[nodiscard]] std::optional<MassCertificate> certificate(Eigen::VectorXd coefficients,
                                                           const Eigen::VectorXd& lower) const;
  /// Masses, errors, smallest, rank, failing conditions; outcome found or undecided by the errors.
  [[nodiscard]] Masses result(const Eigen::VectorXd& masses) const;

 private:
  void solve_for_determined();
};

/// "all six moments are met" or what isn't, with the failing conditions.
[[nodiscard]] std::string describe(const Masses& masses);

}  // namespace nodal::elastic
