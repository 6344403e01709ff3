// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The mutable half of a problem: owns factors and workspaces, evaluates points, keeps a ledger of its work.
///
/// Shapes   x, gradient, v: [space.size()]; residuals, w: [residual_count]; jacobian: row-major
///          [residual_count][space.size()].
/// Units    the cost is smooth and dimensionless; with residuals it is ½ Σ r².
/// Cost     an evaluator keeps its last point: a derivative asked for after a value there repeats nothing of the value.
/// Threads  one evaluator per thread and trial; evaluators of one problem share only immutable data.
/// Errors   a wrong span size or an ability that the problem lacks is std::logic_error; failing numerics are a Status.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/moves.h>
#include <nodal/status.h>

namespace nodal {

/// What evaluating has cost so far. Counts only grow.
struct Work {
  std::int64_t factorizations = 0;
  std::int64_t solves = 0;  ///< right-hand sides solved for
  std::int64_t rank_one_updates = 0;
  double flops = 0.0;                ///< of factorizations and solves, as the factor's structure implies
  double factorization_flops = 0.0;  ///< the part of `flops` that factorizations took

  Work& operator+=(const Work& other) noexcept {
    factorizations += other.factorizations;
    solves += other.solves;
    rank_one_updates += other.rank_one_updates;
    flops += other.flops;
    factorization_flops += other.factorization_flops;
    return *this;
  }
};

/// A figure of the problem's own at a point: "spread", the ratio of the stiffest spring to the softest. What it means
/// says a FindingDescription (command.h).
struct Finding {
  std::string name;
  double value = 0.0;
};

/// How far the numbers of a trial can be trusted, and what else was found at its best point. An entry that was not
/// measured is empty.
struct Health {
  std::optional<double> error_estimate;  ///< relative size of the first refinement step of the final solve
  std::optional<double> cost_error;      ///< the refined cost is within this of the exact one at the same doubles
  std::optional<double> residual;        ///< backward error after refinement, ‖f − Ku‖/(‖f‖ + ‖|K||u|‖)
  std::optional<double> drift;           ///< largest relative_drift() of a cost that the race saw (agreement.h)
  std::int64_t refused = 0;              ///< evaluations that returned another status than ok or budget_spent
  std::vector<Finding> findings;         ///< what the problem says of its best point
  std::optional<double> data_cost = {};  ///< the part of the cost that is no prior's, where there is a prior
};

class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// The cost at x, as accurate as a race needs (agreement.h).
  virtual Evaluation value(std::span<const double> x) = 0;
  /// The cost at x as it is reported: refined as far as double precision goes; fills `health()`.
  virtual Evaluation audit(std::span<const double> x) { return value(x); }

  /// [Problem::held_out] The relative errors at x of what is held out: 0 is perfect, 1 as bad as doing nothing. They
  /// mean something when the status is ok. No part of `work()`, `health()` or the last point.
  [[nodiscard]] virtual Status held_out_errors(std::span<const double> x, std::span<double> errors);

  virtual Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient);
  virtual Evaluation residuals(std::span<const double> x, std::span<double> residuals);
  virtual Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals,
                                            std::span<double> jacobian);

  // At the point of the last successful evaluation; none of these evaluates anything.
  // std::logic_error when there is no such point.

  [[nodiscard]] virtual Status gradient(std::span<double> gradient);
  [[nodiscard]] virtual Status jacobian(std::span<double> jacobian);
  /// jv = J v.
  [[nodiscard]] virtual Status jacobian_product(std::span<const double> v, std::span<double> jv);
  /// jtw = Jᵀ w.
  [[nodiscard]] virtual Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw);

  /// The walker that prices one changed coordinate cheaply, or nullptr. Owned by the evaluator, made at the first call.
  [[nodiscard]] virtual Moves* moves() { return nullptr; }

  [[nodiscard]] virtual Work work() const { return {}; }
  /// Of the last `audit`.
  [[nodiscard]] virtual Health health() const { return {}; }

 protected:
  Evaluator() = default;
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
};

}  // namespace nodal
