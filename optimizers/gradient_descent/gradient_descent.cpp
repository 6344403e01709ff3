// SPDX-License-Identifier: GPL-3.0-or-later
#include "gradient_descent.h"

#include <algorithm>
#include <cmath>

namespace nodal::gradient_descent {

namespace {

constexpr double kEnough = 1e-4;   // of the decrease that the slope promises (Armijo)
constexpr double kNoStep = 1e-15;  // largest change of a variable, in units of their scale
constexpr double kShorter = 0.5, kLonger = 2.0;

// One run: where it is, how long its next step is.
class Run {
 public:
  Run(Meter& meter, const Settings& settings, std::span<const double> start)
      : meter_(meter),
        settings_(settings),
        x_(start.begin(), start.end()),
        trial_(x_),
        gradient_(x_.size()),
        origin_(*std::ranges::max_element(start)) {}

  Status begin();
  /// Why it ends, or nothing when another iteration is worth it.
  std::string iterate();

 private:
  [[nodiscard]] bool exponential() const { return settings_.variables == Variables::exponentials; }
  // The variable of a coordinate; exponentials over the largest of the start, so that they stay numbers.
  [[nodiscard]] double variable(double x) const { return exponential() ? std::exp(x - origin_) : x; }
  [[nodiscard]] double coordinate(double y) const { return exponential() ? origin_ + std::log(std::max(y, 0.0)) : y; }
  // ∂f/∂y.
  [[nodiscard]] double slope(std::size_t i) const {
    return exponential() ? gradient_[i] / variable(x_[i]) : gradient_[i];
  }
  [[nodiscard]] double scale() const;
  void set_first_step();
  double go(double step);

  Meter& meter_;
  const Settings& settings_;
  std::vector<double> x_, trial_, gradient_;
  double origin_, cost_ = 0.0, step_ = 0.0;
  double largest_ = 0.0;  // change of a variable by the last go()
};

double Run::scale() const {
  if (exponential()) return 1.0;
  double widest = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i)
    widest = std::max(widest, meter_.space().upper()[i] - meter_.space().lower()[i]);
  return widest;
}

void Run::set_first_step() {
  double steepest = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) steepest = std::max(steepest, std::abs(slope(i)));
  step_ = steepest > 0.0 ? settings_.first_step * scale() / steepest : 0.0;
}

Status Run::begin() {
  const Evaluation there = meter_.value_and_gradient(x_, gradient_);
  cost_ = there.cost;
  if (there.ok()) set_first_step();
  return there.status;
}

// Makes the trial point; what the slope promises there. What would be no number stays where it is.
double Run::go(double step) {
  double promised = 0.0;
  largest_ = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double there = coordinate(variable(x_[i]) - step * slope(i));
    trial_[i] = std::isnan(there) ? x_[i] : std::clamp(there, meter_.space().lower()[i], meter_.space().upper()[i]);
    const double change = variable(trial_[i]) - variable(x_[i]);
    if (trial_[i] == x_[i] || !std::isfinite(change)) continue;
    promised -= slope(i) * change;
    largest_ = std::max(largest_, std::abs(change));
  }
  return promised;
}

std::string Run::iterate() {
  for (; !meter_.spent(); step_ *= kShorter) {
    const double promised = go(step_);
    if (!(largest_ > kNoStep * scale()))
      return settings_.fixed ? "the step is too small to matter" : "no step is an improvement";
    const Evaluation there = meter_.value(trial_);
    const bool better = there.ok() && there.cost <= cost_ - kEnough * promised && there.cost < cost_;
    if (!better && !settings_.fixed) continue;
    if (!there.ok()) return meter_.spent() ? "the budget is spent" : "the next point can't be evaluated";
    std::swap(x_, trial_);
    cost_ = there.cost;
    if (!settings_.fixed) step_ *= kLonger;
    return meter_.value_and_gradient(x_, gradient_).ok() ? "" : "the gradient failed";
  }
  return "the budget is spent";
}

}  // namespace

Outcome GradientDescent::minimize(Meter& meter, std::span<const double> start, RandomStream&) {
  Run run(meter, settings_, start);
  if (const Status status = run.begin(); status != Status::ok) return without_start(status);
  Outcome outcome;
  outcome.reason = "max_iterations done";
  outcome.limited = true;
  for (int i = 0; i < settings_.max_iterations; ++i) {
    const std::string reason = run.iterate();
    if (reason.empty()) continue;
    outcome.reason = reason;
    outcome.limited = false;
    break;
  }
  return outcome;
}

}  // namespace nodal::gradient_descent
