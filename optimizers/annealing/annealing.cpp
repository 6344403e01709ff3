// SPDX-License-Identifier: GPL-3.0-or-later
#include "annealing.h"

#include <string>

#include "acceptance.h"
#include "move.h"

namespace nodal::annealing {

namespace {

// What happened at one temperature.
struct Tally {
  std::int64_t steps = 0, good = 0, worse = 0;
  double improvement = 0.0;  // of the current G; negative when it rose
};

// The walk through one run: its current value, and the steps of one temperature after the other.
class Walk {
 public:
  Walk(Meter& meter, MeteredMoves& moves, double quality, double step, RandomStream& random)
      : meter_(meter), moves_(moves), quality_(quality), step_(step), random_(random) {}

  Tally run_temperature(double temperature, const Schedule& schedule) {
    Tally tally;
    const double before = quality_;
    while (tally.steps <= schedule.step_limit && tally.good <= schedule.good_step_limit && !meter_.spent()) {
      ++tally.steps;
      step_once(temperature, tally);
    }
    tally.improvement = before - quality_;
    return tally;
  }

 private:
  // A step that can't be evaluated is rejected like one that is infinitely bad.
  void step_once(double temperature, Tally& tally) {
    const Move move = propose_move(meter_.space(), moves_.current_point(), step_, random_);
    const Evaluation proposed = moves_.propose(move.coordinate, move.value);
    if (!proposed.ok()) return;
    const double quality = meter_.quality(proposed.cost);
    const Verdict verdict = judge(quality_, quality, temperature, random_);
    if (verdict == Verdict::rejected || moves_.accept() != Status::ok) return;
    // A walk that found its prices refuted says what its point costs.
    quality_ = moves_.current_cost() == proposed.cost ? quality : meter_.quality(moves_.current_cost());
    ++(verdict == Verdict::good ? tally.good : tally.worse);
  }

  Meter& meter_;
  MeteredMoves& moves_;
  double quality_;  // of the current point: the listing's G_min
  double step_;
  RandomStream& random_;
};

bool converged(const Tally& tally, const Convergence& stop, double start_quality) {
  return stop.enabled && static_cast<double>(tally.worse) <= stop.worse_share * static_cast<double>(tally.steps) &&
         tally.improvement <= stop.improvement * start_quality;
}

Value describe(const Settings& settings, const Schedule& schedule) {
  Value options;
  options.set("initial_temperature", settings.initial_temperature);
  options.set("reduction", schedule.reduction);
  options.set("temperatures", schedule.temperatures);
  options.set("steps", schedule.step_limit);
  options.set("good_steps", schedule.good_step_limit);
  options.set("step", settings.step);
  options.set("stop", settings.convergence.enabled ? "converged" : "temperatures");
  return options;
}

}  // namespace

Schedule make_schedule(const Settings& settings, std::size_t coordinates, double start_quality) {
  const auto e = static_cast<std::int64_t>(coordinates);
  return {settings.initial_temperature * start_quality, settings.reduction, settings.temperatures.value_or(2 * e),
          settings.steps.value_or(2 * e), settings.good_steps.value_or(e)};
}

Outcome Annealing::minimize(Meter& meter, std::span<const double> start, RandomStream& random) {
  MeteredMoves& moves = meter.moves();
  const Evaluation at_start = moves.reset(start);
  if (!at_start.ok()) return without_start(at_start.status);
  Outcome outcome;
  const double start_quality = meter.quality(at_start.cost);
  const Schedule schedule = make_schedule(settings_, meter.space().size(), start_quality);
  outcome.effective_options = describe(settings_, schedule);

  Walk walk(meter, moves, start_quality, settings_.step, random);
  Temperature temperature(schedule);
  for (std::int64_t i = 0; i < schedule.temperatures && !meter.spent(); ++i) {
    const Tally tally = walk.run_temperature(temperature.next(), schedule);
    if (!meter.spent() && converged(tally, settings_.convergence, start_quality)) {
      outcome.reason = "converged at temperature " + std::to_string(i);
      return outcome;
    }
  }
  outcome.reason = std::to_string(schedule.temperatures) + " temperatures done";
  return outcome;
}

}  // namespace nodal::annealing
