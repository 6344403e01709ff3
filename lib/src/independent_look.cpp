// SPDX-License-Identifier: GPL-3.0-or-later
#include "independent_look.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <nodal/agreement.h>

namespace nodal {

namespace {

// max_i |P(x − g)_i − x_i| is not changed by the unit of the cost once it is divided by it: long steps end at a bound,
// so the gradient is made relative first.
double stationarity(const Space& space, std::span<const double> x, std::span<const double> gradient, double cost) {
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double stepped = std::clamp(x[i] - gradient[i] / cost, space.lower()[i], space.upper()[i]);
    largest = std::max(largest, std::abs(stepped - x[i]));
  }
  return largest;
}

}  // namespace

IndependentLook look_independently(const Problem& problem, std::span<const double> point, double seen) {
  IndependentLook look;
  const std::vector<double> x(point.begin(), point.end());  // whatever the problem does to its points
  try {
    const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
    const Evaluation fresh = evaluator->audit(x);
    if (!fresh.ok() || !std::isfinite(fresh.cost)) return look;
    if (contradicts(seen, fresh.cost))
      look.refuted = fmt::format("the race saw a cost of {:.6g} at the best point, an evaluator of its own says {:.6g}",
                                 seen, fresh.cost);
    look.record = AuditRecord{.digits = digits_that_hold(relative_drift(seen, fresh.cost))};
    if (!problem.abilities().gradient || !(fresh.cost > kPerfectCost)) return look;
    std::vector<double> gradient(x.size());
    const bool known = evaluator->value_and_gradient(x, gradient).ok() &&
                       std::ranges::all_of(gradient, [](double g) { return std::isfinite(g); });
    if (known) look.record->stationarity = stationarity(problem.space(), x, gradient, fresh.cost);
  } catch (...) {  // a user's problem may throw here as anywhere: there is no answer, and the trial holds without one
  }
  return look;
}

}  // namespace nodal
