// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// An optimizer on its way to a race: as registered, or one that uses a start wrapped in multi-start.

#include <gtest/gtest.h>

#include <ostream>

#include "multi_start.h"
#include "registered.h"
#include "watched_problem.h"

namespace nodal::contracts {

struct Contender {
  std::string name;
  std::string use;
  bool multi_start = false;

  [[nodiscard]] const OptimizerDescription& description() const { return *components().find_optimizer(use); }
  [[nodiscard]] Options options() const { return resolve_options(description().options, Value(), use); }
  [[nodiscard]] std::unique_ptr<Optimizer> make() const {
    const auto make_one = [made = description().make, o = options()] { return made(o); };
    if (multi_start) return std::make_unique<MultiStart>(make_one);
    return make_one();
  }
};

/// How GoogleTest writes a parameter.
inline void PrintTo(const Contender& contender, std::ostream* out) { *out << contender.name; }

inline std::vector<Contender> contenders() {
  std::vector<Contender> all;
  for (const OptimizerDescription& optimizer : components().optimizers()) {
    all.push_back({identifier(optimizer.name), optimizer.name});
    if (optimizer.uses_start) all.push_back({identifier(optimizer.name) + "_multi_start", optimizer.name, true});
  }
  return all;
}

/// Those whose description is as wanted, multi-start left out.
template <class Wanted>
std::vector<Contender> contenders_that(Wanted wanted) {
  std::vector<Contender> some = contenders();
  std::erase_if(some, [&](const Contender& c) { return c.multi_start || !wanted(c.description()); });
  return some;
}

inline std::string name_of(const testing::TestParamInfo<Contender>& info) { return info.param.name; }

/// What the meter saw of one run.
struct Race {
  Outcome outcome;
  Counts counts;
  Stop stop = Stop::none;
  Evaluation start;
  bool has_best = false;
  double best_cost = 0.0;
  std::vector<double> best_point;
  std::vector<std::pair<std::int64_t, double>> trace;  ///< evaluation, quality
  std::uint64_t next_draw = 0;                         ///< of the stream, after the run
};

inline constexpr std::uint64_t kSeed = 20;

inline Race race(Optimizer& optimizer, const Problem& problem, const Limits& limits, std::uint64_t seed = kSeed) {
  const auto evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), limits);
  RandomStream random(seed);
  Race seen;
  seen.start = meter.start();
  seen.outcome = optimizer.minimize(meter, problem.space().start(), random);
  seen.counts = meter.counts();
  seen.stop = meter.stop();
  seen.has_best = meter.has_best();
  seen.best_cost = meter.best_cost();
  seen.best_point.assign(meter.best_point().begin(), meter.best_point().end());
  for (const TracePoint& point : meter.trace()) seen.trace.emplace_back(point.evaluation, point.quality);
  seen.next_draw = random();
  return seen;
}

inline Race race(const Contender& contender, const Problem& problem, const Limits& limits, std::uint64_t seed = kSeed) {
  return race(*contender.make(), problem, limits, seed);
}

}  // namespace nodal::contracts
