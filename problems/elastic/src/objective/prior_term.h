// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The prior: springs are wished to keep the stiffnesses k_0 that they are thought to have,
///
///     cost = ½ mean over springs of ln²(k/k_0),   r_e = ln(k_e/k_0,e)/√springs.
///
/// What the data determine it hardly moves; what they leave open it decides. Softer by a factor counts as much as
/// stiffer by it.
///
/// Cost     value: a logarithm per spring.

#include <memory>
#include <vector>

#include "objective/prior_moves.h"
#include "objective/term.h"

namespace nodal::elastic {

class PriorTerm final : public Term {
 public:
  /// `about`: [springs] k_0, positive; std::invalid_argument otherwise. The parameters must outlive it.
  PriorTerm(const Parameters& parameters, std::vector<double> about);

  [[nodiscard]] std::string_view name() const override { return "prior"; }
  [[nodiscard]] bool is_prior() const override { return true; }
  [[nodiscard]] Abilities abilities() const override {
    return {.gradient = true, .residuals = true, .jacobian_products = true, .moves = true};
  }
  [[nodiscard]] std::size_t residual_count() const override { return about_.size(); }
  [[nodiscard]] std::unique_ptr<TermEvaluator> make_evaluator() const override;

 private:
  const Parameters& parameters_;
  std::vector<double> about_;
};

class PriorEvaluator final : public TermEvaluator {
 public:
  /// Both must outlive it.
  PriorEvaluator(const Parameters& parameters, std::span<const double> about);

  /// Status::invalid_input where a stiffness has no logarithm.
  Evaluation value(const System& system) override { return evaluate<double>(system); }
  Evaluation audit(const System& system) override;
  Status residuals(std::span<double> r) override;
  Status add_gradient(double weight, const SystemGradient& gradient) override;
  Status product(const System& direction, std::span<double> jv) override;
  Status add_transposed_product(std::span<const double> w, const SystemGradient& gradient) override;
  Status jacobian(const Parameters& parameters, std::span<double> rows) override;
  [[nodiscard]] Moves* moves() override;
  [[nodiscard]] Work work() const override { return {}; }
  [[nodiscard]] Health health() const override { return health_; }

 private:
  template <class Real>
  Evaluation evaluate(const System& system);

  const Parameters& parameters_;
  std::span<const double> about_;
  double root_;                        // 1/√springs
  std::span<const double> stiffness_;  // of the point
  std::vector<double> logarithm_;      // ln(k/k_0) there
  Health health_;
  std::unique_ptr<PriorMoves> moves_;
};

}  // namespace nodal::elastic
