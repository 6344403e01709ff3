// SPDX-License-Identifier: GPL-3.0-or-later
#include "warm_up.h"

#include <algorithm>
#include <memory>

#include "trial_audit.h"
#include "trial_search.h"
#include "work_clock.h"

namespace nodal {

namespace {

// A local method is near its end after so many, and the code of the others is as warm as it gets.
constexpr std::int64_t kMostEvaluations = 300;
constexpr double kMostSeconds = 0.02;
constexpr double kMostOfABudget = 0.05;
// To a better point: the clock itself takes some 50 ns, an interrupt some microseconds.
constexpr double kShortestToldToAPoint = 1e-4;

Limits limits_of(const Study& study) {
  const Limits whole = trial_limits(study);
  return {std::min(kMostSeconds, kMostOfABudget * whole.seconds), std::min(kMostEvaluations, whole.evaluations)};
}

std::vector<TracePoint> begin_trial(const Study& study, const Trial& trial, const Registry& registry) {
  const Limits limits = limits_of(study);
  const Problem& problem = *study.problems.at(trial.problem).problem;
  const Meter::Clock::time_point began = Meter::Clock::now();
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  const std::vector<double> start = trial_start(study, trial);
  Meter meter(problem, *evaluator, start, limits, began);
  (void)search(study, trial, registry, meter, start);
  // What is reported takes other ways than the race; on a large problem they aren't worth a second of everybody's.
  if (meter.seconds_now() < limits.seconds) {
    TrialRecord nobodys;
    TrialAudit(problem, *evaluator, meter, nobodys).note_start(start);
  }
  return meter.trace();
}

}  // namespace

WarmUp warm_up(const Study& study, const Trial& trial, const Registry& registry) {
  WarmUp result;
  const Meter::Clock::time_point began = Meter::Clock::now();
  try {
    result.trace = begin_trial(study, trial, registry);
  } catch (...) {
    result.trace.clear();
  }
  result.seconds = seconds_between(began, Meter::Clock::now());
  return result;
}

std::optional<double> times_as_cold(const WarmUp& before, const TrialRecord& record) {
  for (auto cold = before.trace.rbegin(); cold != before.trace.rend() && cold->evaluation > 0; ++cold) {
    const auto warm = std::ranges::lower_bound(record.trace, cold->evaluation, {}, &TracePoint::evaluation);
    const bool same =
        warm != record.trace.end() && warm->evaluation == cold->evaluation && warm->quality == cold->quality;
    if (same)
      return warm->seconds < kShortestToldToAPoint ? std::nullopt : std::optional(cold->seconds / warm->seconds);
  }
  return std::nullopt;
}

}  // namespace nodal
