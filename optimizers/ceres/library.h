// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What both kinds of Ceres' minimizers share: silence, stopping, and how an end is judged.

#include <ceres/iteration_callback.h>
#include <ceres/types.h>

#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/meter.h>
#include <nodal/optimizer.h>

namespace nodal::ceres_methods {

/// Ceres logs through glog, which writes to stderr unless told not to.
void silence();

/// "DENSE_QR" → "dense-qr": the library's words as studies write them.
[[nodiscard]] std::string in_kebab_case(std::string_view words);

/// Tolerances at which a minimizer ends by itself; 0 switches one off.
struct Tolerances {
  double function = 1e-16;   ///< |Δcost| ≤ this · cost: a step gains nothing any more
  double gradient = 1e-16;   ///< max |∂cost/∂x_i| ≤ this
  double parameter = 1e-14;  ///< |Δx| ≤ this · |x|
};

/// One run as both sides see it: no exception passes through Ceres, and a spent meter ends it.
class Watch final : public ::ceres::IterationCallback {
 public:
  explicit Watch(Meter& meter) : meter_(meter), point_(meter.space().size()) {}

  /// Calls `evaluate(x)`, x in the box, unless the run is over. False for anything but an ok result: Ceres then
  /// takes a smaller step. Never lets it see a NaN, for which it would write pages.
  template <typename Evaluate>
  bool call(const double* x, Evaluate&& evaluate) noexcept {
    if (over()) return false;
    try {
      point_.assign(x, x + point_.size());
      meter_.space().clamp(point_);
      const Evaluation result = evaluate(std::span<const double>(point_));
      if (result.ok() && (!seen_ || result.cost < lowest_)) lowest_ = result.cost;
      if (result.ok() && !seen_) first_ = result.cost;
      seen_ = seen_ || result.ok();
      return result.ok();
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }
  ::ceres::CallbackReturnType operator()(const ::ceres::IterationSummary&) override {
    return over() ? ::ceres::SOLVER_TERMINATE_SUCCESSFULLY : ::ceres::SOLVER_CONTINUE;
  }

  [[nodiscard]] bool over() const noexcept { return thrown_ || meter_.spent(); }
  [[nodiscard]] bool lowered() const noexcept { return seen_ && lowest_ < first_; }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  Meter& meter_;
  std::vector<double> point_;
  std::exception_ptr thrown_;
  bool seen_ = false;
  double first_ = 0.0, lowest_ = 0.0;
};

/// `start`, moved off the bounds that it touches by a thousandth of the box: Ceres sticks to a bound that it starts on.
[[nodiscard]] std::vector<double> strictly_inside(const Space& space, std::span<const double> start);

/// Ceres reports convergence even when its first evaluation failed: so only a lower cost counts as success, and FAILURE
/// after one is merely how a line search ends where rounding hides the rest. NO_CONVERGENCE is a limit of its own.
void judge(Outcome& outcome, const Watch& watch, ::ceres::TerminationType type, const std::string& message);

/// After FAILURE, Ceres says neither what cost it had reached nor where: its summary has −1, its x is the start.
[[nodiscard]] Claim make_claim(::ceres::TerminationType type, double cost, std::vector<double> x,
                               std::optional<std::int64_t> evaluations);

}  // namespace nodal::ceres_methods
