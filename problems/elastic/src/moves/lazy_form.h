// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Keeps the lane factor and the displacements only, and solves for each proposal: cheapest while most are accepted,
/// and the form for tied springs, whose change has as low a rank as there are springs in the group.
///
/// The springs of a change are taken one after the other: z_i = K⁻¹b_i is corrected for those before it by Sherman and
/// Morrison, and moves the displacements by −z_i δ(b_i·u)/(1 + δ b_i·z_i). G'² is summed from the displacements, so
/// nothing cancels.
///
/// Cost     price: per spring one path and one full pass over the factor; accept: per spring one path.
/// Memory   the factor, displacements twice, one vector per spring of the largest group.
/// Threads  one per thread.

#include <vector>

#include "displacements/lane_model.h"
#include "moves/pricing_form.h"

namespace nodal::elastic {

class LazyForm final : public PricingForm {
 public:
  LazyForm(const ElasticModel& model, const LaneModel& lanes);

  bool reset(std::span<const double> stiffness, const FullEvaluation& solved) override;
  Priced price(const Change& change) override;
  bool accept(const Change& change) override;
  void set_squared(double /*squared*/) override {}  // it keeps none: each price is summed afresh
  [[nodiscard]] Work work() const override;

 private:
  const ElasticModel& model_;
  std::vector<LaneSystem> systems_;
  std::vector<AlignedArray> current_, proposed_;  // displacements by system, [slots] vectors
  std::vector<AlignedArray> solutions_;           // z by system, one vector per spring of a change
  std::int64_t factorizations_ = 0, solves_ = 0, changes_ = 0;
};

}  // namespace nodal::elastic
