// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The objective: ½ Σ_terms w_t Σ r², a sum of the terms that are fitted; and the terms that are held out.
///
/// Residuals of fitted terms stand one after the other, each times √w_t. Held-out terms are evaluated where their
/// errors are asked for, part by part, and nowhere else: a value, an audit, a derivative or a walk doesn't know of
/// them, nor does what is said of work and health. A single fitted term of weight 1 costs nothing more than the term:
/// its own walk is the walk. Several walk beside each other (objective_moves.h), unless one of them has no walk: then
/// the ability is gone, and the meter walks by full values.
///
/// Threads  Objective: immutable, shared. ObjectiveEvaluator: one thread.

#include <memory>
#include <span>
#include <string>
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
  /// The parts of what is held out, in order.
  [[nodiscard]] std::vector<std::string> held_out_parts() const;
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
  /// `health` is that of the first fitted term that estimates its error (of the first where none does), with the errors
  /// of all costs added up, and, where there is a prior, the cost of the terms that are none.
  Evaluation audit(const System& system);
  /// [held_out_parts] The first term that fails ends it.
  [[nodiscard]] Status held_out_errors(const System& system, std::span<double> errors);

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

  struct HeldOut {
    const Term* term;
    std::unique_ptr<TermEvaluator> evaluator;  // made when it is asked for: a race never does
    std::size_t parts;
  };

  std::vector<Part> parts_;
  std::vector<HeldOut> held_out_;
  std::vector<double> scaled_;             // w of a transposed product, times √w_t
  std::unique_ptr<ObjectiveMoves> moves_;  // of several terms
  Health health_;
};

}  // namespace nodal::elastic
