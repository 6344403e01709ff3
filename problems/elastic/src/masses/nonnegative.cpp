// SPDX-License-Identifier: GPL-3.0-or-later
#include "nonnegative.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/QR>

namespace nodal::elastic {

namespace {

// The columns that are positive, with their unconstrained least-squares solution.
class PassiveSet {
 public:
  PassiveSet(const Eigen::MatrixXd& g, const Eigen::VectorXd& b) : g_(g), b_(b), s_(Eigen::VectorXd::Zero(g.cols())) {}

  const Eigen::VectorXd& s() const { return s_; }
  Eigen::VectorXd residual() const {
    Eigen::VectorXd rest = b_;
    for (const Eigen::Index j : columns_) rest -= s_[j] * g_.col(j);
    return rest;
  }
  bool full() const { return static_cast<Eigen::Index>(columns_.size()) >= g_.rows(); }
  bool has(Eigen::Index j) const { return std::ranges::find(columns_, j) != columns_.end(); }

  // Lets a column in and moves to the best point of the set, dropping columns that reach zero on the way. False when
  // rounding alone made the column look useful: the set is as before.
  bool enter(Eigen::Index entering) {
    columns_.push_back(entering);
    Eigen::VectorXd best = solve();
    if (!(best[best.size() - 1] > 0.0)) {
      columns_.pop_back();
      return false;
    }
    while (best.minCoeff() <= 0.0) {
      double share = 1.0;
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const double at = s_[columns_[k]], to = best[static_cast<Eigen::Index>(k)];
        if (to <= 0.0) share = std::min(share, at / (at - to));
      }
      std::vector<Eigen::Index> kept;
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        double& at = s_[columns_[k]];
        const double to = best[static_cast<Eigen::Index>(k)];
        at += share * (to - at);
        if (to <= 0.0 && at <= std::numeric_limits<double>::epsilon() * -to) at = 0.0;
        if (at > 0.0) kept.push_back(columns_[k]);
      }
      if (kept.size() == columns_.size() || kept.empty()) return false;
      columns_ = std::move(kept);
      best = solve();
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) s_[columns_[k]] = best[static_cast<Eigen::Index>(k)];
    return true;
  }

 private:
  Eigen::VectorXd solve() const {
    Eigen::MatrixXd chosen(g_.rows(), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) chosen.col(static_cast<Eigen::Index>(k)) = g_.col(columns_[k]);
    return chosen.colPivHouseholderQr().solve(b_);
  }

  const Eigen::MatrixXd& g_;
  const Eigen::VectorXd& b_;
  std::vector<Eigen::Index> columns_;
  Eigen::VectorXd s_;
};

}  // namespace

NonnegativeSolution nonnegative_least_squares(const Eigen::MatrixXd& g, const Eigen::VectorXd& b) {
  constexpr int kSteps = 1000;  // a few times the number of rows is usual
  PassiveSet passive(g, b);
  // A gain this small is rounding of the dot product that measures it.
  const double tolerance = 16.0 * std::numeric_limits<double>::epsilon() * b.norm() * g.colwise().norm().maxCoeff();
  bool settled = false;
  for (int step = 0; step < kSteps && !settled; ++step) {
    Eigen::VectorXd gain = g.transpose() * passive.residual();
    settled = true;
    while (settled) {
      Eigen::Index j = 0;
      if (gain.maxCoeff(&j) <= tolerance) break;
      if (!passive.has(j) && passive.enter(j)) settled = false;
      gain[j] = 0.0;
    }
  }
  return {passive.s(), passive.residual(), settled};
}

}  // namespace nodal::elastic
