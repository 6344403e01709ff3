// SPDX-License-Identifier: GPL-3.0-or-later
// What every optimizer promises, whatever it is (optimizer.h), on a toy with every ability.
#include <gtest/gtest.h>

#include "contender.h"

namespace nodal::contracts {
namespace {

class EveryOptimizer : public testing::TestWithParam<Contender> {};
class DeterministicOptimizer : public testing::TestWithParam<Contender> {};
class StartlessOptimizer : public testing::TestWithParam<Contender> {};

constexpr std::int64_t kEvaluations = 2000;

TEST_P(EveryOptimizer, EndsBetterThanItStarted) {
  const Race seen = race(GetParam(), WatchedProblem(), {.evaluations = kEvaluations});
  EXPECT_FALSE(seen.outcome.failed) << seen.outcome.reason;
  EXPECT_GT(seen.counts.evaluations, 0);
  EXPECT_LT(seen.best_cost, seen.start.cost);
  EXPECT_TRUE(seen.stop != Stop::none || !seen.outcome.reason.empty()) << "ended by itself and doesn't say why";
}

TEST_P(EveryOptimizer, HasTheBestValueAtItsBestPoint) {
  const WatchedProblem problem;
  const Race seen = race(GetParam(), problem, {.evaluations = kEvaluations});
  EXPECT_EQ(problem.make_evaluator()->value(seen.best_point).cost, seen.best_cost);
}

TEST_P(EveryOptimizer, GivesTheSameTraceForTheSameSeed) {
  const WatchedProblem problem;
  const Race a = race(GetParam(), problem, {.evaluations = kEvaluations});
  const Race b = race(GetParam(), problem, {.evaluations = kEvaluations});
  EXPECT_EQ(a.trace, b.trace);
  EXPECT_EQ(a.best_point, b.best_point);
  EXPECT_EQ(a.counts.evaluations, b.counts.evaluations);
  EXPECT_EQ(a.next_draw, b.next_draw);
}

TEST_P(EveryOptimizer, RunsASecondTimeAsTheFirst) {
  const WatchedProblem problem;
  const auto optimizer = GetParam().make();
  const Race first = race(*optimizer, problem, {.evaluations = kEvaluations});
  const Race second = race(*optimizer, problem, {.evaluations = kEvaluations});
  EXPECT_EQ(first.trace, second.trace);
  EXPECT_EQ(first.best_point, second.best_point);
}

// One that runs between must not matter either: libraries have generators and states of their own.
TEST_P(EveryOptimizer, IsNotDisturbedByAnotherRunBetween) {
  const WatchedProblem problem;
  const Race before = race(GetParam(), problem, {.evaluations = 500});
  (void)race(GetParam(), problem, {.evaluations = 123}, kSeed + 1);
  const Race after = race(GetParam(), problem, {.evaluations = 500});
  EXPECT_EQ(before.trace, after.trace);
}

TEST_P(DeterministicOptimizer, DrawsNothing) {
  const WatchedProblem problem;
  const Race a = race(GetParam(), problem, {.evaluations = kEvaluations}, 1);
  const Race b = race(GetParam(), problem, {.evaluations = kEvaluations}, 2);
  EXPECT_EQ(a.trace, b.trace);
  EXPECT_EQ(a.next_draw, RandomStream(1)());
}

TEST_P(StartlessOptimizer, DoesNotLookAtTheStart) {
  const auto points_from = [](double start) {
    std::vector<std::vector<double>> points;
    const WatchedProblem problem({.start = std::vector<double>(4, start)},
                                 [&points](std::span<const double> x, Evaluation result) {
                                   points.emplace_back(x.begin(), x.end());
                                   return result;
                                 });
    (void)race(GetParam(), problem, {.evaluations = 200});
    points.erase(points.begin());  // the harness evaluates the start
    return points;
  };
  EXPECT_EQ(points_from(-0.3), points_from(2.1));
}

TEST_P(EveryOptimizer, StaysInTheBox) {
  Toy toy;
  const std::vector<std::vector<double>> starts = {{-1.2, 1.0, -1.2, 1.0},
                                                   std::vector<double>(4, toy.lower),
                                                   std::vector<double>(4, toy.upper),
                                                   {toy.lower, toy.upper, toy.lower, 0.3}};
  for (const std::vector<double>& start : starts) {
    toy.start = start;
    const Space* space = nullptr;
    std::int64_t outside = 0;
    const WatchedProblem problem(toy, [&](std::span<const double> x, Evaluation result) {
      if (space && !space->contains(x)) ++outside;
      return result;
    });
    space = &problem.space();
    const Race seen = race(GetParam(), problem, {.evaluations = kEvaluations});
    EXPECT_EQ(outside, 0);
    EXPECT_FALSE(seen.outcome.failed) << seen.outcome.reason;
    EXPECT_LE(seen.best_cost, seen.start.cost);
  }
}

TEST_P(EveryOptimizer, StaysInABoxThatLeavesTheOptimumOutside) {
  const Space* space = nullptr;
  std::int64_t outside = 0;
  const WatchedProblem problem({.lower = -2.0, .upper = 0.5, .start = {-1.2, 0.5, -1.2, 0.4}},
                               [&](std::span<const double> x, Evaluation result) {
                                 if (space && !space->contains(x)) ++outside;
                                 return result;
                               });
  space = &problem.space();
  const Race seen = race(GetParam(), problem, {.evaluations = kEvaluations});
  EXPECT_EQ(outside, 0);
  EXPECT_LT(seen.best_cost, seen.start.cost);
}

TEST_P(EveryOptimizer, KeepsABudgetOf37Evaluations) {
  std::int64_t calls = 0;
  const WatchedProblem problem({}, [&calls](std::span<const double>, Evaluation result) {
    ++calls;
    return result;
  });
  const Race seen = race(GetParam(), problem, {.evaluations = 37});
  EXPECT_LE(seen.counts.evaluations, 37);
  // The start is the harness's; a walk is reset where it starts, which prices nothing. Multi-start resets once a run.
  EXPECT_LE(calls, 37 + 1 + (seen.counts.proposed > 0 ? 37 : 0));
  // Methods that look up only between generations get that far, and no further.
  EXPECT_LE(seen.counts.refused, 1000);
}

TEST_P(EveryOptimizer, KeepsABudgetOfOneEvaluation) {
  const Race seen = race(GetParam(), WatchedProblem(), {.evaluations = 1});
  EXPECT_LE(seen.counts.evaluations, 1);
  EXPECT_LE(seen.counts.refused, 1000);
}

TEST_P(EveryOptimizer, StopsAtItsTarget) {
  const WatchedProblem problem;
  const auto evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), {.evaluations = 100000});
  meter.set_target(0.9 * problem.quality(meter.start().cost));
  RandomStream random(kSeed);
  (void)GetParam().make()->minimize(meter, problem.space().start(), random);
  EXPECT_EQ(meter.stop(), Stop::target);
  EXPECT_LE(meter.counts().refused, 1000);
}

TEST_P(EveryOptimizer, WorksInOneDimension) {
  for (const double start : {-1.2, -2.0, 3.0}) {
    const Race seen = race(GetParam(), WatchedProblem({.dimension = 1, .start = {start}}), {.evaluations = 300});
    EXPECT_LE(seen.counts.evaluations, 300);
    if (!seen.outcome.failed) {
      EXPECT_LT(seen.best_cost, seen.start.cost) << "from " << start;
    } else {
      EXPECT_FALSE(seen.outcome.reason.empty());
    }
  }
}

// Some methods are for few coordinates only: they may refuse, with a reason.
TEST_P(EveryOptimizer, WorksInThirtyDimensionsOrSaysWhyNot) {
  const Race seen = race(GetParam(), WatchedProblem({.dimension = 30}), {.evaluations = 300});
  EXPECT_LE(seen.counts.evaluations, 300);
  EXPECT_LE(seen.best_cost, seen.start.cost);
  if (seen.outcome.failed) {
    EXPECT_FALSE(seen.outcome.reason.empty());
  } else {
    EXPECT_GT(seen.counts.evaluations, 0);
  }
}

// A toy that can do just that throws at everything else.
TEST_P(EveryOptimizer, AsksForNoMoreThanItNeeds) {
  const WatchedProblem problem({.abilities = GetParam().description().needs});
  const Race seen = race(GetParam(), problem, {.evaluations = 500});
  EXPECT_FALSE(seen.outcome.failed) << seen.outcome.reason;
  EXPECT_LT(seen.best_cost, seen.start.cost);
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryOptimizer, testing::ValuesIn(contenders()), name_of);
INSTANTIATE_TEST_SUITE_P(Registered, DeterministicOptimizer,
                         testing::ValuesIn(contenders_that([](const auto& o) { return o.deterministic; })), name_of);
INSTANTIATE_TEST_SUITE_P(Registered, StartlessOptimizer,
                         testing::ValuesIn(contenders_that([](const auto& o) { return !o.uses_start; })), name_of);
// A build without adapters may have no such methods.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DeterministicOptimizer);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StartlessOptimizer);

}  // namespace
}  // namespace nodal::contracts
