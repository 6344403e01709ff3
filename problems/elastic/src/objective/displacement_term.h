// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The paper's term: how far the displacements under the loads are from the body's, cost = ½ (G/‖u_ref‖_W)².
///
/// Values come from the lanes where the study lets them and they vouch for them, from CHOLMOD otherwise; audits always
/// come from CHOLMOD, refined. Derivatives come from whichever solved for the point. The walk is ElasticMoves.
///
/// Cost     value: one factorization of all groups, one solve per load.

#include <memory>
#include <string>
#include <vector>

#include "displacements/full_evaluation.h"
#include "displacements/lane_evaluation.h"
#include "moves/elastic_moves.h"
#include "objective/term.h"

namespace nodal::elastic {

class DisplacementTerm final : public Term {
 public:
  /// The model must outlive it.
  explicit DisplacementTerm(const ElasticModel& model) : model_(model) {}

  [[nodiscard]] std::string_view name() const override { return "displacements"; }
  [[nodiscard]] Abilities abilities() const override {
    return {.gradient = true, .residuals = true, .jacobian_products = true, .moves = true};
  }
  [[nodiscard]] std::size_t residual_count() const override { return model_.residual_count; }
  /// The loads.
  [[nodiscard]] std::vector<std::string> parts() const override;
  [[nodiscard]] std::unique_ptr<TermEvaluator> make_evaluator() const override;

 private:
  const ElasticModel& model_;
};

class DisplacementEvaluator final : public TermEvaluator {
 public:
  explicit DisplacementEvaluator(const ElasticModel& model);

  Evaluation value(const System& system) override;
  Evaluation audit(const System& system) override;
  Status residuals(std::span<double> r) override;
  Status add_gradient(double weight, const SystemGradient& gradient) override;
  Status product(const System& direction, std::span<double> jv) override;
  Status add_transposed_product(std::span<const double> w, const SystemGradient& gradient) override;
  /// std::invalid_argument for other parameters than the model's, whose ties its loops know.
  Status jacobian(const Parameters& parameters, std::span<double> rows) override;
  /// Of each load G_l/‖u_ref,l‖_W, by CHOLMOD: the lanes are for races.
  [[nodiscard]] Status part_errors(const System& system, std::span<double> errors) override;
  [[nodiscard]] Moves* moves() override;
  [[nodiscard]] Work work() const override;
  [[nodiscard]] Health health() const override { return health_; }

 private:
  [[nodiscard]] FullEvaluation& full();

  const ElasticModel& model_;
  bool by_lanes_;
  std::unique_ptr<LaneEvaluation> lanes_;  // both made when first needed: a race may never need CHOLMOD's factors
  std::unique_ptr<FullEvaluation> full_;
  PointDerivatives* solver_ = nullptr;  // the one of the two that solved for the point
  std::vector<double> by_spring_;
  Health health_;
  std::unique_ptr<ElasticMoves> moves_;
};

}  // namespace nodal::elastic
