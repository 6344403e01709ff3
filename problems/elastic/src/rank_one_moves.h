// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Prices one changed spring by rank-one algebra instead of a factorization.
///
/// For spring e changed by δ: with z = K⁻¹b_e and α = δ(b_e·u)/(1 + δ b_e·z), the displacements become u − αz
/// (Sherman–Morrison), and the cost is summed from them directly: no difference of squares, so nothing cancels near a
/// perfect fit. 1 + δ b_e·z ≤ 0 means that K + δ b bᵀ is not positive definite.
///
/// Cost     propose: one solve per support group; accept: one factorization per group, so that nothing drifts.
/// Threads  one per thread.

#include <memory>
#include <vector>

#include "elastic_model.h"

namespace nodal::elastic {

class RankOneMoves final : public Moves {
 public:
  /// For parameters that are one to one with springs.
  explicit RankOneMoves(const ElasticModel& model);

  Evaluation reset(std::span<const double> x) override;
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override;
  [[nodiscard]] std::span<const double> current_point() const override { return x_; }
  Evaluation resync() override;

  [[nodiscard]] Work work() const;

 private:
  Evaluation solve();
  double price(Equilibrium& equilibrium, std::size_t spring, double change, Status& status);

  const ElasticModel& model_;
  std::vector<std::unique_ptr<Equilibrium>> equilibria_;
  std::vector<double> x_, stiffness_;
  std::size_t changed_ = 0;
  double proposed_x_ = 0.0;
  bool acceptable_ = false;
  std::int64_t priced_ = 0;
};

}  // namespace nodal::elastic
