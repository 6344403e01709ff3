// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_search.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

#include <nodal/agreement.h>

#include "multi_start.h"

namespace nodal {

namespace {

std::unique_ptr<Optimizer> make_optimizer(const StudyOptimizer& entry, const Registry& registry) {
  const OptimizerDescription* description = registry.find_optimizer(entry.use);
  if (!description) throw std::logic_error("optimizer '" + entry.use + "' is not registered");
  if (!entry.multi_start) return description->make(entry.options);
  return std::make_unique<MultiStart>([description, &entry] { return description->make(entry.options); });
}

// A start that is a perfect fit, as far as races can tell, is at its target.
void set_target(const Study& study, const Trial& trial, Meter& meter) {
  if (!meter.start().ok()) return;
  const double quality = meter.quality(meter.start().cost);
  double target = -std::numeric_limits<double>::infinity();
  if (std::isfinite(quality)) target = target_quality(study, trial, quality);
  const bool perfect = std::isfinite(target) && std::abs(meter.start().cost) <= kPerfectCost;
  meter.set_target(perfect ? std::max(target, quality) : target);
}

Outcome failure(const std::string& reason) {
  Outcome outcome;
  outcome.failed = true;
  outcome.reason = reason;
  return outcome;
}

}  // namespace

std::uint64_t stream_key(const Study& study, const std::string& problem, const std::string& purpose, int repeat) {
  constexpr std::uint64_t kLow53Bits = (std::uint64_t{1} << 53) - 1;
  const Value::List parts = {Value(study.seed), Value(problem), Value(purpose), Value(repeat)};
  return hash64(to_canonical_json(Value(parts))) & kLow53Bits;
}

std::uint64_t trial_seed(const Study& study, const Trial& trial) {
  return stream_key(study, study.problems.at(trial.problem).label,
                    "optimizer " + study.optimizers.at(trial.optimizer).label, trial.repeat);
}

Limits trial_limits(const Study& study) {
  Limits limits;
  if (study.budget.seconds) limits.seconds = *study.budget.seconds;
  if (study.budget.evaluations) limits.evaluations = *study.budget.evaluations;
  return limits;
}

Outcome search(const Study& study, const Trial& trial, const Registry& registry, Meter& meter,
               std::span<const double> start) {
  RandomStream random(trial_seed(study, trial));
  try {
    set_target(study, trial, meter);
    const std::unique_ptr<Optimizer> optimizer = make_optimizer(study.optimizers.at(trial.optimizer), registry);
    return optimizer->minimize(meter, start, random);
  } catch (const std::exception& error) {
    return failure(error.what());
  } catch (...) {
    return failure("an exception that is no std::exception");
  }
}

}  // namespace nodal
