// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Pricing from a list: four numbers per spring, group and load price any proposal in O(1), and every accepted change
/// brings the whole list up to date in O(springs) (lanes/lane_kernels.h has the formulas).
///
/// Where ẑ = δK'⁻¹b and K'⁻¹Wẑ come from is the derived class's business: EagerForm has them from the lane factor,
/// UpdownForm from CHOLMOD's.
///
/// G'² comes as a difference, G² + Σ α(αR − 2t). By Cauchy and Schwarz its terms are at most about (G + G')², so digits
/// are lost only where G' ≪ G; a proposal that good is evaluated in full, and so is one that leaves a group hardly
/// held.
///
/// Cost     price O(1); accept O(springs) and the solves.
/// Memory   (2 + 2·loads per group) numbers per spring and lane.
/// Threads  one per thread.

#include <vector>

#include "displacements/lane_model.h"
#include "displacements/lane_system.h"
#include "moves/pricing_form.h"

namespace nodal::elastic {

class TableForm : public PricingForm {
 public:
  /// For parameters that are one to one with springs.
  TableForm(const ElasticModel& model, const LaneModel& lanes);

  bool reset(std::span<const double> stiffness, const FullEvaluation& solved) final;
  Priced price(const Change& change) final;
  bool accept(const Change& change) final;
  void set_squared(double squared) final { squared_ = squared; }
  [[nodiscard]] Work work() const final;

 protected:
  /// Factors K(stiffness). False when it is not positive definite.
  virtual bool factorize(std::span<const double> stiffness) = 0;
  /// True when the factor solves for the loads as the full evaluation did.
  virtual bool vouches(std::span<const double> stiffness, const FullEvaluation& solved) = 0;
  /// z = K⁻¹b_e into system `s`'s view.z.
  virtual void solve_spring(std::size_t s, std::size_t spring) = 0;
  /// The factor of the changed K, ẑ and K'⁻¹Wẑ into view.z and view.y of every system. False when that fails.
  virtual bool change(std::size_t spring, double delta) = 0;
  /// Flops and counts of what the three above have done.
  [[nodiscard]] virtual Work solver_work() const = 0;

  [[nodiscard]] const ElasticModel& model() const noexcept { return model_; }
  [[nodiscard]] std::vector<LaneSystem>& systems() noexcept { return systems_; }
  [[nodiscard]] const std::vector<LaneSystem>& systems() const noexcept { return systems_; }

 private:
  // What pricing a spring touches of a system, side by side.
  struct List {
    LanePrice (*price)(const LaneView&, const double*, double);
    const LaneView* view;
    double* rows;
    std::size_t stride;
  };

  Priced price_in_full(const Change& change);

  const ElasticModel& model_;
  std::vector<LaneSystem> systems_;
  std::vector<AlignedArray> tables_;
  std::vector<List> lists_;
  std::vector<double> stiffness_;
  double squared_ = 0.0, priced_ = 0.0;
  std::unique_ptr<FullEvaluation> full_;  // made when a proposal first needs it
};

}  // namespace nodal::elastic
