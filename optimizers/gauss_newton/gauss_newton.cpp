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
constexpr double kPoor = 0.25, kFair = 0.5, kGood = 0.75;
constexpr double kLate = 0.05;  // of the cost: a step that promises less begins the late phase
constexpr double kShorter = 0.25;

// A point and what is known there.
struct Place {
  std::vector<double> x, residuals;
  double cost = 0.0;

  explicit Place(const Meter& meter) : x(meter.space().size()), residuals(meter.residual_count()) {}
  Status look(Meter& meter) {
    meter.space().clamp(x);
    const Evaluation there = meter.residuals(x, residuals);
    cost = there.cost;
    return there.status;
  }
  [[nodiscard]] bool evaluate(Meter& meter) { return look(meter) == Status::ok; }
};

// One run: the place it is at, the region it trusts.
class Run {
 public:
  Run(Meter& meter, const Settings& settings)
      : meter_(meter),
        settings_(settings),
        cg_(meter, settings.pairs),
        radius_(settings.initial_radius),
        here_(meter),
        trial_(meter),
        corrected_(meter),
        gradient_(meter.space().size()),
        box_{std::vector<double>(meter.space().size()), std::vector<double>(meter.space().size())} {}

  Status begin(std::span<const double> start);
  /// Why it ends, or nothing when another iteration is worth it.
  std::string iterate();

 private:
  [[nodiscard]] double width(std::size_t i) const { return meter_.space().upper()[i] - meter_.space().lower()[i]; }
  void set_box(std::span<const double> x);
  double longest() const;
  double curvature() const;
  bool search();
  bool correct();

  Meter& meter_;
  const Settings& settings_;
  TruncatedCg cg_;
  double radius_;
  bool late_ = false;
  Place here_, trial_, corrected_;
  std::vector<double> gradient_;
  Box box_;
  Step step_, correction_;
};

// At the start moved a little; at the start itself where that can't be evaluated.
Status Run::begin(std::span<const double> start) {
  Status status = Status::invalid_input;
  for (const double jitter : {settings_.jitter, 0.0}) {
    RandomStream draws(kJitterSeed);  // not the trial's: the method is the same every time
    here_.x.assign(start.begin(), start.end());
    for (std::size_t i = 0; i < start.size() && jitter > 0.0; ++i)
      here_.x[i] += jitter * width(i) * draws.uniform(-1.0, 1.0);
    status = here_.look(meter_);
    if (status == Status::ok) break;
  }
  return status;
}

void Run::set_box(std::span<const double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    box_.lower[i] = std::max(meter_.space().lower()[i] - x[i], -radius_ * width(i));
    box_.upper[i] = std::min(meter_.space().upper()[i] - x[i], radius_ * width(i));
  }
}

// The step's longest component, as a share of the box.
double Run::longest() const {
  double share = 0.0;
  for (std::size_t i = 0; i < step_.p.size(); ++i)
    if (width(i) > 0.0) share = std::max(share, std::abs(step_.p[i]) / width(i));
  return share;
}

// |J p|² of the step.
double Run::curvature() const {
  double sum = 0.0;
  for (std::size_t a = 0; a < here_.residuals.size(); ++a) {
    const double change = step_.residuals[a] - here_.residuals[a];
    sum += change * change;
  }
  return sum;
}

std::string Run::iterate() {
  if (meter_.jacobian_transposed_product(here_.residuals, gradient_) != Status::ok) return "a product failed";
  set_box(here_.x);
  const Status status = cg_.solve(here_.residuals, gradient_, box_, late_ ? settings_.late : settings_.early, step_);
  if (meter_.spent()) return "the budget is spent";
  // A product that failed midway leaves a shorter step, which is one nevertheless.
  if (status != Status::ok && step_.iterations == 0) return "a product failed";
  const double promised = here_.cost - 0.5 * dot(step_.residuals, step_.residuals);
  if (!(promised > settings_.cost_tolerance * here_.cost)) return "a step promises no more than cost_tolerance";
  if (promised < kLate * here_.cost) late_ = true;
  if (!search()) return meter_.spent() ? "the budget is spent" : "no step is an improvement";
  return {};
}

// Takes the step, corrected where that is needed, or the first shorter one that keeps enough of what it promises.
// The meter's last point is then the one taken, as the next products need it.
bool Run::search() {
  const double slope = dot(gradient_, step_.p), curved = curvature(), whole = longest();
  for (double length = 1.0; length * whole > kSmallestRadius && !meter_.spent(); length *= kShorter) {
    for (std::size_t i = 0; i < here_.x.size(); ++i) trial_.x[i] = here_.x[i] + length * step_.p[i];
    const double promised = -length * slope - 0.5 * length * length * curved;
    double kept = 0.0;
    if (trial_.evaluate(meter_)) {
      kept = (here_.cost - trial_.cost) / promised;
      if (length == 1.0 && kept < kFair && settings_.correction_iterations > 0)
        kept = correct() ? (here_.cost - trial_.cost) / promised : 0.0;
    }
    if (kept < kPoor) radius_ = std::max(0.5 * length * whole, kSmallestRadius);
    if (kept > kGood && length == 1.0 && step_.at_side) radius_ = std::min(2.0 * radius_, kLargestRadius);
    if (!(kept > kAcceptable)) continue;
    std::swap(here_, trial_);
    return true;
  }
  return false;
}

// Goes on from the trial point, by the few directions that the residuals feel most; whether that is lower.
bool Run::correct() {
  if (meter_.jacobian_transposed_product(trial_.residuals, gradient_) != Status::ok) return false;
  set_box(trial_.x);
  const CgLimits limits{settings_.correction_iterations, settings_.early.tolerance};
  if (cg_.solve(trial_.residuals, gradient_, box_, limits, correction_) != Status::ok) return false;
  for (std::size_t i = 0; i < trial_.x.size(); ++i) corrected_.x[i] = trial_.x[i] + correction_.p[i];
  if (!corrected_.evaluate(meter_) || !(corrected_.cost < trial_.cost)) return false;
  std::swap(trial_, corrected_);
  return true;
}

}  // namespace

Outcome GaussNewton::minimize(Meter& meter, std::span<const double> start, RandomStream&) {
  Run run(meter, settings_);
  if (const Status status = run.begin(start); status != Status::ok) return without_start(status);
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

}  // namespace nodal::gauss_newton
