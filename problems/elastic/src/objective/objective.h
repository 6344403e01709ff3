// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The objective: ½ Σ_terms w_t Σ r², a sum of the terms that are fitted; and the terms that are held out.
///
/// Residuals of fitted terms stand one after the other, each times √w_t. Held-out terms are evaluated at audits, after
/// the fitted ones, and told as findings under their names: √(2 · their cost). An audit doesn't fail by them; a value,
/// a derivative or a walk doesn't know of them. A single fitted term of weight 1 costs nothing more than the term: its
/// own walk is the walk. Several walk beside each other (objective_moves.h), unless one of them has no walk: then the
/// ability is gone, and the meter walks by full values.
///
/// Threads  Objective: immutable, shared. ObjectiveEvaluator: one thread.

#include <memory>
#include <span>
#include <vector>

#include "objective/objective_moves.h"
#include "objective/term.h"

namespace nodal::elastic {

struct WeightedTerm {
  std::shared_ptr<const Term> term;
  double weight = 1.0;  ///< > 0
};

class ObjectiveEvaluator;

class Objective {
 public:
  /// std::invalid_argument without a fitted term, or for a weight that is not positive.
  explicit Objective(std::vector<WeightedTerm> fitted, std::vector<std::shared_ptr<const Term>> held_out = {});

  /// What all fitted terms have.
  [[nodiscard]] Abilities abilities() const;
  [[nodiscard]] std::size_t residual_count() const;
  [[nodiscard]] const std::vector<WeightedTerm>& fitted() const noexcept { return fitted_; }
  [[nodiscard]] const std::vector<std::shared_ptr<const Term>>& held_out() const noexcept { return held_out_; }
  /// The objective must outlive it.
  [[nodiscard]] std::unique_ptr<ObjectiveEvaluator> make_evaluator() const;

 private:
  std::vector<WeightedTerm> fitted_;
  std::vector<std::shared_ptr<const Term>> held_out_;
};

/// As a TermEvaluator of all of them.
class ObjectiveEvaluator {
 public:
  explicit ObjectiveEvaluator(const Objective& objective);

  Evaluation value(const System& system);
  /// Fitted terms, then those held out. `health` is that of the first fitted term that estimates its error (of the
  /// first where none does), with the errors of all costs added up, the findings of those held out after its own, and,
  /// where there is a prior, the cost of the terms that are none.
  Evaluation audit(const System& system);

  Status residuals(std::span<double> r);
  Status add_gradient(const SystemGradient& gradient);
  Status product(const System& direction, std::span<double> jv);
  Status add_transposed_product(std::span<const double> w, const SystemGradient& gradient);
  Status jacobian(const Parameters& parameters, std::span<double> rows);

  /// Nothing where a fitted term has none.
  [[nodiscard]] Moves* moves();
  [[nodiscard]] Work work() const;
  [[nodiscard]] const Health& health() const noexcept { return health_; }

 private:
  struct Part {
    std::unique_ptr<TermEvaluator> evaluator;
    double weight, root;  // w, √w
    bool prior;
    std::size_t residuals, first;  // how many, where they begin
  };

  template <class Ask>
  Evaluation sum_of(Ask ask);
  void add_health(const Part& part);

  std::vector<Part> parts_;
  std::vector<std::string> held_out_names_;
  std::vector<std::unique_ptr<TermEvaluator>> held_out_;
  std::vector<double> scaled_;             // w of a transposed product, times √w_t
  std::unique_ptr<ObjectiveMoves> moves_;  // of several terms
  Health health_;
};

}  // namespace nodal::elastic
