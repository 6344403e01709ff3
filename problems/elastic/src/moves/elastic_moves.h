// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The elastic problem's walk: owns the point, prices changes by the form that costs least, and watches its rounding.
///
/// Choice   a form is left for another once it has cost more, on the walk so far, than the other would have by as much
///          as taking over costs (the rule of renting or buying: at most about twice the cost of knowing in advance).
///          Costs come from CostModel, so equal runs choose equally. `scene.moves.form` forces one.
/// Drift    the point's G² is compared with a fresh full evaluation after `interval` accepted changes, and sooner when
/// a
///          bound on its rounding, Σ 8ε(G² + G'²), exceeds 1e-9 of it. The interval is what the drift found allows for
///          staying below a tenth of 1e-9, growing at most twofold. A drift above that makes the form start anew.
/// Loss     G² may be right and the next price wrong all the same: what a form keeps is brought up to date by
/// differences,
///          so its errors are relative to what it once was. Since the form began, with n changes accepted and p the
///          largest ratio between two stiffnesses that one spring has had, factor and compliances have lost nεp; and
///          displacements, which once were as far off as G was, Σε(G + ‖u_ref‖)/G of the present G. Once four times the
///          sum of both exceeds 1e-9, the form starts anew before the next price. (Near a perfect fit, where any
///          evaluation is noise, it may be 1e-12 ‖u_ref‖/G.)
///
/// Cost     propose: the form's price, an exponential, two indirect calls. No allocation after a form's first calls.
/// Threads  one per thread.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "moves/cost_model.h"
#include "moves/pricing_form.h"

namespace nodal::elastic {

class ElasticMoves final : public Moves {
 public:
  explicit ElasticMoves(const ElasticModel& model);
  ~ElasticMoves() override;

  Evaluation reset(std::span<const double> x) override;
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override;
  [[nodiscard]] std::span<const double> current_point() const override { return x_; }
  Evaluation resync() override;
  [[nodiscard]] MovesReport report() const override { return report_; }
  [[nodiscard]] std::int64_t contradictions() const override { return contradictions_; }

  [[nodiscard]] Work work() const;

 private:
  Status solve_fresh();
  void use(std::size_t form, std::string reason);
  void begin_form();
  Status accept_afresh(double before);
  void review();
  void check_drift();
  double note_drift(double priced);
  void forget_loss();
  bool loses_too_much(std::size_t i, double x);

  const ElasticModel& model_;
  const LaneModel& lanes_;
  const CostModel costs_;
  FullEvaluation fresh_;
  // Forms are told by their line in pricing_forms(); `full_` is that of the one that needs no trust.
  const std::size_t full_ = index_of(pricing_forms(), kFullForm);
  std::size_t kind_ = full_;
  std::unique_ptr<PricingForm> form_;
  Work past_;  // of forms that were left

  std::vector<std::span<const std::size_t>> springs_;  // by coordinate, at hand for the hot path
  std::vector<double> x_, lowest_, highest_;           // the last two: of each coordinate since the form began
  std::vector<double> stiffness_;
  double squared_ = 0.0;  // G² of the point
  // The last proposal.
  Change change_;
  std::size_t changed_ = 0;
  double proposed_x_ = 0.0, proposed_squared_ = 0.0;
  bool acceptable_ = false;

  // Renting or buying: how much more than each other form the present one has cost.
  std::vector<double> regret_;                                  // [forms]
  std::int64_t proposed_ = 0, accepted_ = 0;                    // in all
  std::int64_t reviewed_proposed_ = 0, reviewed_accepted_ = 0;  // … at the last review
  std::int64_t until_review_ = 0;

  std::int64_t since_check_ = 0, interval_;
  double rounding_ = 0.0;  // bound on what G² has gathered since it was fresh
  // What the form has lost since it began: the widest stretch of a coordinate and its ratio of stiffnesses, Σ G +
  // ‖u_ref‖.
  double widest_ = 0.0, ratio_ = 1.0, travelled_ = 0.0;
  std::int64_t updates_ = 0;
  std::int64_t contradictions_ = 0;
  MovesReport report_;
};

}  // namespace nodal::elastic
