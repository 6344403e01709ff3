// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Factors the changed system anew for each proposal, all groups at once in the lanes: for tied springs, where a change
/// has too high a rank for anything less.
///
/// Cost     price: one factorization and one solve per load, in lanes; accept: nothing.
/// Threads  one per thread.

#include <memory>
#include <vector>

#include "displacements/lane_model.h"
#include "moves/pricing_form.h"

namespace nodal::elastic {

class RefactorForm final : public PricingForm {
 public:
  RefactorForm(const ElasticModel& model, const LaneModel& lanes);

  bool reset(std::span<const double> stiffness, const FullEvaluation& solved) override;
  Priced price(const Change& change) override;
  bool accept(const Change& change) override;
  void set_squared(double /*squared*/) override {}
  [[nodiscard]] Work work() const override;

 private:
  Priced price_in_full();

  const ElasticModel& model_;
  std::vector<LaneSystem> systems_;
  std::vector<AlignedArray> displacements_;
  std::vector<double> stiffness_, proposed_;
  std::unique_ptr<FullEvaluation> full_;  // made when a proposal first needs it
  std::int64_t factorizations_ = 0, solves_ = 0;
};

}  // namespace nodal::elastic
