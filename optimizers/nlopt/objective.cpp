// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective.h"

#include <algorithm>
#include <cmath>

namespace nodal::nlopt_methods {

namespace {

// A start whose cost changes by less than this share of itself per unit of any coordinate is a minimum that somebody
// wrote down with four digits or more: a line search has nothing to gain there but rounding.
constexpr double kLevelSlope = 1e-4;
// ½ r² of r = 1e-8: the libraries' line searches have constants of their own, and see no slope below that.
constexpr double kNothingLeft = 0.5e-16;
constexpr double kPenalty = 1e30;  // far above any cost, and its square is still finite

double penalty(std::span<double> gradient) {
  std::ranges::fill(gradient, 0.0);
  return kPenalty;
}

}  // namespace

Objective::Objective(Meter& meter, nlopt_opt library, std::optional<double> first_cost)
    : meter_(meter), library_(library), first_cost_(first_cost), point_(meter.space().size()) {}

void Objective::stop() noexcept {
  stopped_ = true;
  nlopt_force_stop(library_);
}

double Objective::call(unsigned n, const double* x, double* gradient, void* self) noexcept {
  Objective& objective = *static_cast<Objective*>(self);
  const std::span<double> gradient_span = gradient ? std::span<double>(gradient, n) : std::span<double>{};
  try {
    return objective.evaluate({x, n}, gradient_span);
  } catch (...) {
    objective.thrown_ = std::current_exception();
    objective.stop();
    return penalty(gradient_span);
  }
}

double Objective::evaluate(std::span<const double> x, std::span<double> gradient) {
  if (meter_.spent() && !stopped_) stop();
  if (stopped_) return penalty(gradient);
  const std::int64_t before = meter_.counts().evaluations;
  Evaluation result;
  if (std::ranges::none_of(x, [](double xi) { return std::isnan(xi); })) {
    std::ranges::copy(x, point_.begin());
    meter_.space().clamp(point_);
    result = gradient.empty() ? meter_.value(point_) : meter_.value_and_gradient(point_, gradient);
  }
  idle_ = meter_.counts().evaluations == before ? idle_ + 1 : 0;
  if (meter_.spent() || stuck()) stop();
  if (!result.ok()) return penalty(gradient);
  if (std::isinf(first_) && !gradient.empty()) first_slope_ = steepest_slope(gradient);
  note(result.cost);
  for (double& slope : gradient) slope *= scale_;
  return result.cost * scale_;
}

// Of the ways that stay in the box.
double Objective::steepest_slope(std::span<const double> gradient) const {
  double steepest = 0.0;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const bool leads_out = gradient[i] > 0.0 ? point_[i] <= meter_.space().lower()[i]  //
                                             : point_[i] >= meter_.space().upper()[i];
    if (!leads_out) steepest = std::max(steepest, std::abs(gradient[i]));
  }
  return steepest;
}

bool Objective::began_at_minimum() const noexcept {
  return std::isfinite(first_) && (first_ <= kNothingLeft || first_slope_ <= kLevelSlope * std::abs(first_));
}

void Objective::note(double cost) {
  if (std::isinf(first_)) {
    first_ = cost;
    if (first_cost_ && cost > 0.0) scale_ = std::exp2(std::round(std::log2(*first_cost_ / cost)));
  }
  lowest_ = std::min(lowest_, cost);
}

}  // namespace nodal::nlopt_methods
