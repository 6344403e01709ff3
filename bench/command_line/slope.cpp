// SPDX-License-Identifier: GPL-3.0-or-later
#include "slope.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace nodal {

std::optional<double> promised_share(const Problem& problem, std::span<const double> x) {
  constexpr double kStep = 1e-3, kAsGoodAsPerfect = 1e-6;
  if (!problem.abilities().gradient) return std::nullopt;
  const Space& space = problem.space();
  std::vector<double> gradient(space.size());
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  const Evaluation at = evaluator->value_and_gradient(x, gradient);
  if (!at.ok() || !std::isfinite(at.cost)) return std::nullopt;
  if (std::sqrt(2.0 * std::abs(at.cost)) <= kAsGoodAsPerfect) return 0.0;
  double promise = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double room = gradient[i] > 0.0 ? x[i] - space.lower()[i] : space.upper()[i] - x[i];
    const double step = kStep * (space.upper()[i] - space.lower()[i]);
    promise += std::abs(gradient[i]) * std::clamp(room, 0.0, step);
  }
  return promise / std::abs(at.cost);
}

}  // namespace nodal
