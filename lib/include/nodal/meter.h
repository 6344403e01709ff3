// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The optimizer's view of an evaluator, and the one instrument that measures all optimizers alike.
///
/// It counts, clocks, keeps the best point, the trace, the budget and the target. Optimizers neither count, log, print
/// nor time themselves. What is counted:
///   one evaluation = one cost seen at one point: a value, a value and gradient, residuals with or without Jacobian, or
///   one proposal priced. A derivative or product at the last point is none; accept, reset, resync and audits are none.
/// After the budget nothing is evaluated: `budget_spent` is returned and the refused call counted. A cost that is not a
/// finite number becomes `invalid_input`. Exceptions of the problem pass through unchanged.
/// The best point is one of the box: a better cost outside of it is noted and not taken. A best that a walk has only
/// priced is confirmed by a full evaluation, which is not counted, before it ends a trial at its target, and whenever a
/// fresh evaluation of the walk refutes its prices (agreement.h). If it is refuted itself, it is taken back: the best
/// and the trace are again what they were when last confirmed, and the trial goes on.
///
/// Cost     a value that triggers nothing: under 40 ns, no allocation. The clock is not read at every evaluation but
///          about every 0.1 ms, so that it stays below 1 % of cheap evaluations; time spent in evaluations is sampled
///          at the same moments. An improvement reads it once.
/// Threads  one meter per trial and thread.

#include <chrono>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include <nodal/evaluator.h>
#include <nodal/kept_points.h>
#include <nodal/problem.h>

namespace nodal {

/// When a trial is stopped; whichever comes first. Infinite where not set.
struct Limits {
  double seconds = std::numeric_limits<double>::infinity();  ///< wall time since the trial began
  std::int64_t evaluations = std::numeric_limits<std::int64_t>::max();
};

enum class Stop { none, evaluations, seconds, target };

struct Counts {
  std::int64_t evaluations = 0;
  std::int64_t values = 0;
  std::int64_t gradients = 0;
  std::int64_t residuals = 0;
  std::int64_t jacobians = 0;
  std::int64_t products = 0;
  std::int64_t proposed = 0;
  std::int64_t accepted = 0;
  std::int64_t refused = 0;  ///< calls after the budget: nothing was evaluated
};

/// A cost that would have been the best, at a point outside the box.
struct OutsidePoint {
  std::int64_t evaluation = 0;
  std::size_t coordinate = 0;  ///< the first that leaves its bounds, or is no number
  double value = 0.0;
};

/// Keeps at most `most` points, evenly spaced in the logarithm of the evaluation; the first and the last stay, and of
/// each interval the best.
void thin_trace(std::vector<TracePoint>& trace, std::size_t most);

class Meter;

/// The walk of moves.h, metered: each proposal is one evaluation and may set the best.
class MeteredMoves {
 public:
  Evaluation reset(std::span<const double> x);
  Evaluation propose(std::size_t i, double value);
  [[nodiscard]] Status accept();
  [[nodiscard]] std::span<const double> current_point() const { return moves_->current_point(); }
  /// Of the current point: as it was priced, unless a fresh evaluation during accept() has refuted that.
  [[nodiscard]] double current_cost() const noexcept;
  Evaluation resync();

 private:
  friend class Meter;
  MeteredMoves(Meter& meter, Moves& moves) : meter_(&meter), moves_(&moves) {}
  Meter* meter_;
  Moves* moves_;
};

class Meter {
 public:
  using Clock = std::chrono::steady_clock;

  /// Evaluates the start once, uncounted: it is the first best point, evaluation 0 of the trace.
  /// `began` is when the trial began; seconds count from there. What `Problem::quality` throws of the start is kept for
  /// `set_target`, so that the trial knows what the start cost.
  Meter(const Problem& problem, Evaluator& evaluator, std::span<const double> start, const Limits& limits,
        Clock::time_point began = Clock::now());
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  // ── for optimizers ────────────────────────────────────────────────────────────────────────────────────────────────

  [[nodiscard]] const Space& space() const noexcept { return space_; }
  [[nodiscard]] Abilities abilities() const { return problem_.abilities(); }
  [[nodiscard]] std::size_t residual_count() const { return problem_.residual_count(); }
  /// What people read, monotone in the cost.
  [[nodiscard]] double quality(double cost) const { return problem_.quality(cost); }
  /// True once nothing is evaluated any more: return from `minimize` soon.
  [[nodiscard]] bool spent() const noexcept { return stop_ != Stop::none; }

  Evaluation value(std::span<const double> x);
  /// At the last point nothing is evaluated or counted: only the derivative is computed. So for the next two.
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient);
  Evaluation residuals(std::span<const double> x, std::span<double> residuals);
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian);
  /// J v and Jᵀ w at the last evaluated point; `budget_spent` after the budget.
  [[nodiscard]] Status jacobian_product(std::span<const double> v, std::span<double> jv);
  [[nodiscard]] Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw);
  /// The problem's own pricing of single changes, or full evaluations where it has none. One walk per meter.
  [[nodiscard]] MeteredMoves& moves();

  // ── for the harness ───────────────────────────────────────────────────────────────────────────────────────────────

  [[nodiscard]] Evaluation start() const noexcept { return start_; }
  /// Stops as soon as the best quality is ≤ this; at once when it is already. Throws what the problem's quality threw
  /// of the start.
  void set_target(double quality);
  [[nodiscard]] bool has_best() const noexcept { return best_evaluation_ >= 0; }
  [[nodiscard]] double best_cost() const noexcept { return best_cost_; }
  [[nodiscard]] std::span<const double> best_point() const noexcept { return best_x_; }
  [[nodiscard]] std::int64_t best_evaluation() const noexcept { return best_evaluation_; }
  /// The best point as one of those kept. There must be one.
  [[nodiscard]] KeptPoint best() const;
  [[nodiscard]] Stop stop() const noexcept { return stop_; }
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
  /// Evaluations that returned another status than ok.
  [[nodiscard]] std::int64_t failed_evaluations() const noexcept { return failed_; }
  /// The first better point that was outside the box.
  [[nodiscard]] const std::optional<OutsidePoint>& outside() const noexcept { return outside_; }
  /// The largest difference between a priced and a fresh cost that a resync of the walk, or the walk itself, has found:
  /// relative_drift() of agreement.h.
  [[nodiscard]] std::optional<double> drift() const;
  /// What the walk says of itself, when there was one and it has something to say.
  [[nodiscard]] std::optional<MovesReport> moves_report() const;
  [[nodiscard]] const std::vector<TracePoint>& trace() const noexcept { return trace_; }
  /// Best points before the last, where the problem holds something out: to be looked at after the trial.
  [[nodiscard]] const std::vector<KeptPoint>& kept() const noexcept { return kept_.points(); }
  /// Wall time in the problem, estimated: evaluations and accepted moves from the sampled ones, the rest in full.
  [[nodiscard]] double evaluation_seconds() const noexcept { return evaluation_seconds_; }
  [[nodiscard]] double seconds_now() const noexcept;

 private:
  friend class MeteredMoves;

  // Admits one evaluation, or refuses it. Every `stride_` evaluations the slow path reads the clock.
  bool admit() noexcept {
    if (counts_.evaluations >= limits_.evaluations || stop_ != Stop::none) [[unlikely]]
      return refuse();
    ++counts_.evaluations;
    if (--until_sample_ == 0) [[unlikely]]
      return begin_sample();
    return true;
  }
  // A method that gives another number of coordinates would be read or written beyond its end.
  void require_size(std::span<const double> x) const {
    if (x.size() != best_x_.size()) [[unlikely]]
      throw std::invalid_argument(
          "the method asked for a point with another number of coordinates than the problem has");
  }
  bool refuse() noexcept;
  bool begin_sample() noexcept;
  void end_sample() noexcept;

  template <class Compute>
  Status product(Compute compute);
  // What every evaluation ends with: sanitizes the result and looks whether it is an improvement.
  Evaluation settle(Evaluation result, std::span<const double> x);
  void improve(std::span<const double> x, double cost, std::size_t changed, double changed_value);
  bool inside(std::span<const double> x, std::size_t changed, double changed_value);
  void look_again();
  bool confirm_best();
  void take_back(const Evaluation& fresh);
  bool at_last_point(std::span<const double> x) const noexcept;
  void keep_last_point(std::span<const double> x, const Evaluation& result);
  void note_drift(double expected, const Evaluation& fresh);

  const Problem& problem_;
  Evaluator& evaluator_;
  const Space& space_;
  Limits limits_;
  double target_quality_ = -std::numeric_limits<double>::infinity();
  Clock::time_point began_;

  Stop stop_ = Stop::none;
  Counts counts_;
  std::int64_t failed_ = 0;
  Evaluation start_;

  double best_cost_ = std::numeric_limits<double>::infinity();
  std::vector<double> best_x_;
  std::int64_t best_evaluation_ = -1;
  bool best_priced_ = false;  // and not confirmed by a full evaluation
  std::vector<TracePoint> trace_;
  KeptPoints kept_;
  std::optional<OutsidePoint> outside_;
  std::exception_ptr start_thrown_;  // by the problem's quality

  // The best before those that were only priced.
  struct Confirmed {
    double cost;
    std::vector<double> x;
    std::int64_t evaluation;
    TracePoint point;
  } confirmed_;
  std::int64_t contradictions_ = 0, taken_back_ = 0;

  std::vector<double> last_x_;
  Evaluation last_;

  std::int64_t until_sample_ = 1;
  std::int64_t stride_ = 1;
  bool sampling_ = false;
  Clock::time_point sample_began_, previous_sample_;
  double evaluation_seconds_ = 0.0;

  std::unique_ptr<Moves> adapter_;  // where the problem has no moves of its own
  std::unique_ptr<MeteredMoves> moves_;
  double walk_cost_ = 0.0;  // of the walk's current point, as priced
  double proposed_cost_ = 0.0;
  std::optional<double> drift_;
};

inline double MeteredMoves::current_cost() const noexcept { return meter_->walk_cost_; }

}  // namespace nodal
