// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem annealed in some way, and what came of it.

#include "toy.h"

namespace nodal::annealing {

struct Annealed {
  Outcome outcome;
  Counts counts;
  double best_quality = 0.0;
};

inline Annealed annealed(const toy::ToyProblem& problem, Optimizer&& optimizer, const Limits& limits,
                         std::uint64_t key) {
  const auto evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), limits);
  RandomStream random(key);
  Annealed run;
  run.outcome = optimizer.minimize(meter, problem.space().start(), random);
  run.counts = meter.counts();
  run.best_quality = meter.quality(meter.best_cost());
  return run;
}

}  // namespace nodal::annealing
