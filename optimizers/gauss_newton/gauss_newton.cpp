// SPDX-License-Identifier: GPL-3.0-or-later
#include "gauss_newton.h"

#include <algorithm>
#include <cmath>

#include "vectors.h"

namespace nodal::gauss_newton {

namespace {

constexpr std::uint64_t kJitterSeed = 1;
constexpr double kLargestRadius = 1.0;
constexpr double kSmallestRadius = 1e-12;
constexpr double kAcceptable = 1e-3;  // of the decrease that the model promises
constexpr double kPoor = 0.25, kGood = 0.75;
constexpr double kShorter = 0.25;

// One run: the point it is at, what is known there, the region it trusts.
class Run {
 public:
  Run(Meter& meter, const Settings& settings)
      : meter_(meter),
        settings_(settings),
        cg_(meter, settings.cg),
        radius_(settings.initial_radius),
        trial_(meter.space().size()),
        gradient_(meter.space().size()),
        residuals_(meter.residual_count()),
        trial_residuals_(meter.residual_count()),
        box_{std::vector<double>(meter.space().size()), std::vector<double>(meter.space().size())} {}

  bool begin(std::span<const double> start);
  /// Why it ends, or nothing when another iteration is worth it.
  std::string iterate();

 private:
  [[nodiscard]] double width(std::size_t i) const { return meter_.space().upper()[i] - meter_.space().lower()[i]; }
  void set_box();
  double longest() const;
  bool search();

  Meter& meter_;
  const Settings& settings_;
  TruncatedCg cg_;
  double radius_;
  double cost_ = 0.0;
  std::vector<double> x_, trial_, gradient_, residuals_, trial_residuals_;
  Box box_;
  Step step_;
};

// At the start moved a little; at the start itself where that can't be evaluated.
bool Run::begin(std::span<const double> start) {
  for (const double jitter : {settings_.jitter, 0.0}) {
    RandomStream draws(kJitterSeed);  // not the trial's: the method is the same every time
    x_.assign(start.begin(), start.end());
    for (std::size_t i = 0; i < x_.size() && jitter > 0.0; ++i) x_[i] += jitter * width(i) * draws.uniform(-1.0, 1.0);
    meter_.space().clamp(x_);
    const Evaluation there = meter_.residuals(x_, residuals_);
    cost_ = there.cost;
    if (there.ok()) return true;
  }
  return false;
}

void Run::set_box() {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    box_.lower[i] = std::max(meter_.space().lower()[i] - x_[i], -radius_ * width(i));
    box_.upper[i] = std::min(meter_.space().upper()[i] - x_[i], radius_ * width(i));
  }
}

// The step's longest component, as a share of the box.
double Run::longest() const {
  double share = 0.0;
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (width(i) > 0.0) share = std::max(share, std::abs(step_.p[i]) / width(i));
  return share;
}

std::string Run::iterate() {
  if (meter_.jacobian_transposed_product(residuals_, gradient_) != Status::ok) return "a product failed";
  set_box();
  const Status status = cg_.solve(residuals_, gradient_, box_, step_);
  if (meter_.spent()) return "the budget is spent";
  // A product that failed midway leaves a shorter step, which is one nevertheless.
  if (status != Status::ok && step_.iterations == 0) return "a product failed";
  const double promised = cost_ - 0.5 * dot(step_.residuals, step_.residuals);
  if (!(promised > settings_.cost_tolerance * cost_)) return "a step promises no more than cost_tolerance";
  if (!search()) return meter_.spent() ? "the budget is spent" : "no step is an improvement";
  return {};
}

// Takes the step, or the first shorter one that keeps enough of what it promises.
bool Run::search() {
  const double slope = dot(gradient_, step_.p);
  double curvature = 0.0;
  for (std::size_t a = 0; a < residuals_.size(); ++a) {
    const double change = step_.residuals[a] - residuals_[a];
    curvature += change * change;
  }
  const double whole = longest();
  for (double length = 1.0; length * whole > kSmallestRadius && !meter_.spent(); length *= kShorter) {
    for (std::size_t i = 0; i < x_.size(); ++i) trial_[i] = x_[i] + length * step_.p[i];
    meter_.space().clamp(trial_);
    const Evaluation there = meter_.residuals(trial_, trial_residuals_);
    const double promised = -length * slope - 0.5 * length * length * curvature;
    const double kept = there.ok() ? (cost_ - there.cost) / promised : 0.0;
    if (kept < kPoor) radius_ = std::max(0.5 * length * whole, kSmallestRadius);
    if (kept > kGood && length == 1.0 && step_.at_side) radius_ = std::min(2.0 * radius_, kLargestRadius);
    if (!(kept > kAcceptable)) continue;
    std::swap(x_, trial_);
    std::swap(residuals_, trial_residuals_);
    cost_ = there.cost;
    return true;
  }
  return false;
}

}  // namespace

Outcome GaussNewton::minimize(Meter& meter, std::span<const double> start, RandomStream&) {
  Outcome outcome;
  Run run(meter, settings_);
  if (!run.begin(start)) {
    outcome.reason = "the start can't be evaluated";
    return outcome;
  }
  outcome.reason = "max_iterations done";
  for (int i = 0; i < settings_.max_iterations; ++i) {
    const std::string reason = run.iterate();
    if (reason.empty()) continue;
    outcome.reason = reason;
    break;
  }
  return outcome;
}

}  // namespace nodal::gauss_newton
