// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/meter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>

#include "../support/count_allocations.h"
#include "toy.h"

namespace nodal {
namespace {

struct Bench {
  explicit Bench(const Limits& limits = {}, toy::Cost cost = toy::bowl)
      : problem(3, std::move(cost)),
        evaluator(problem.make_evaluator()),
        meter(problem, *evaluator, problem.space().start(), limits) {}
  toy::ToyProblem problem;
  std::unique_ptr<Evaluator> evaluator;
  Meter meter;
};

TEST(Meter, KeepsTheStartAsItsFirstBest) {
  Bench b;
  EXPECT_TRUE(b.meter.has_best());
  EXPECT_EQ(b.meter.best_evaluation(), 0);
  EXPECT_EQ(b.meter.counts().evaluations, 0);
  EXPECT_EQ(b.meter.best_cost(), toy::bowl(b.problem.space().start()));
  ASSERT_EQ(b.meter.trace().size(), 1u);
  EXPECT_EQ(b.meter.trace()[0].evaluation, 0);
}

TEST(Meter, CountsACostSeenAtAPointOnce) {
  Bench b;
  std::vector<double> x = {0.0, 0.1, 0.2}, g(3), r(3), jacobian(9);
  ASSERT_TRUE(b.meter.value(x).ok());
  ASSERT_TRUE(b.meter.value_and_gradient(x, g).ok());
  ASSERT_TRUE(b.meter.residuals_and_jacobian(x, r, jacobian).ok());
  EXPECT_EQ(b.meter.counts().evaluations, 1);
  x[0] = 0.5;
  ASSERT_TRUE(b.meter.residuals(x, r).ok());
  ASSERT_TRUE(b.meter.residuals_and_jacobian(x, r, jacobian).ok());
  EXPECT_EQ(b.meter.counts().evaluations, 2);
  ASSERT_TRUE(b.meter.value(x).ok());  // a plain value is always one, seen before or not
  EXPECT_EQ(b.meter.counts().evaluations, 3);
  EXPECT_EQ(b.meter.counts().values, 2);
  EXPECT_EQ(b.meter.counts().gradients, 1);
  EXPECT_EQ(b.meter.counts().residuals, 3);
  EXPECT_EQ(b.meter.counts().jacobians, 2);
}

TEST(Meter, EvaluatesNothingAfterTheBudget) {
  Bench b({.evaluations = 2});
  std::vector<double> x = {0.0, 0.0, 0.0}, g(3);
  EXPECT_TRUE(b.meter.value(x).ok());
  EXPECT_FALSE(b.meter.spent());
  x[0] = 0.1;
  EXPECT_TRUE(b.meter.value_and_gradient(x, g).ok());
  const std::int64_t work = b.evaluator->work().factorizations;
  const std::vector<double> optimum = {0.25, 0.5, 0.75};
  EXPECT_EQ(b.meter.value(optimum).status, Status::budget_spent);
  EXPECT_EQ(b.meter.value_and_gradient(x, g).status, Status::budget_spent);
  EXPECT_EQ(b.meter.moves().propose(0, 0.25).status, Status::budget_spent);
  EXPECT_TRUE(b.meter.spent());
  EXPECT_EQ(b.meter.stop(), Stop::evaluations);
  EXPECT_EQ(b.meter.counts().evaluations, 2);
  EXPECT_EQ(b.meter.counts().refused, 3);
  EXPECT_EQ(b.evaluator->work().factorizations, work);
  EXPECT_NE(std::vector(b.meter.best_point().begin(), b.meter.best_point().end()), optimum);
}

TEST(Meter, StopsAtTheTarget) {
  Bench b;
  b.meter.set_target(0.5);
  EXPECT_FALSE(b.meter.spent());
  const std::vector<double> near = {0.3, 0.5, 0.7};
  EXPECT_TRUE(b.meter.value(near).ok());
  EXPECT_EQ(b.meter.stop(), Stop::target);
  EXPECT_EQ(b.meter.value(near).status, Status::budget_spent);
}

TEST(Meter, StopsAtTheDeadline) {
  Bench b({.seconds = 0.02}, [](std::span<const double> x) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return toy::bowl(x);
  });
  std::vector<double> x = {0, 0, 0};
  int calls = 0;
  while (!b.meter.spent() && calls < 1000) {
    x[0] += 1e-3;
    (void)b.meter.value(x);
    ++calls;
  }
  EXPECT_EQ(b.meter.stop(), Stop::seconds);
  EXPECT_LE(calls, 5);  // at least 5 ms each
  for (const TracePoint& p : b.meter.trace()) EXPECT_LT(p.seconds, 0.02);
}

TEST(Meter, TurnsCostsThatAreNoNumbersIntoAStatus) {
  for (const double bad :
       {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    Bench b({}, [bad](std::span<const double> x) { return x[0] > 0.0 ? bad : toy::bowl(x); });
    const std::vector<double> x = {1.0, 0.0, 0.0};
    EXPECT_EQ(b.meter.value(x).status, Status::invalid_input);
    EXPECT_EQ(b.meter.failed_evaluations(), 1);
    EXPECT_EQ(b.meter.best_evaluation(), 0);
  }
}

TEST(Meter, LetsExceptionsOfTheProblemThrough) {
  Bench b({}, [](std::span<const double> x) -> double {
    if (x[0] > 0.0) throw std::out_of_range("the plate broke");
    return toy::bowl(x);
  });
  const std::vector<double> x = {1.0, 0.0, 0.0};
  EXPECT_THROW((void)b.meter.value(x), std::out_of_range);
}

TEST(Meter, AllocatesNothingPerEvaluation) {
  Bench b;
  std::vector<double> x = {-1.0, -1.0, -1.0}, g(3);
  (void)b.meter.value_and_gradient(x, g);
  MeteredMoves& moves = b.meter.moves();
  (void)moves.reset(x);
  const long before = allocation_count();
  for (int i = 0; i < 20000; ++i) {  // each an improvement: more than the trace holds
    x[0] += 1e-5;
    (void)b.meter.value(x);
  }
  for (int i = 0; i < 1000; ++i)
    if (moves.propose(0, -1.0 + 1e-4 * i).ok()) (void)moves.accept();
  EXPECT_EQ(allocation_count(), before);
  EXPECT_LE(b.meter.trace().size(), 4000u);
}

TEST(Meter, WalksByFullEvaluationWhereAProblemHasNoMoves) {
  Bench b;
  MeteredMoves& moves = b.meter.moves();
  const std::vector<double> x = {0.0, 0.0, 0.0};
  EXPECT_EQ(moves.reset(x).cost, toy::bowl(x));
  EXPECT_EQ(b.meter.counts().evaluations, 0);
  const std::vector<double> y = {0.0, 0.5, 0.0};
  EXPECT_EQ(moves.propose(1, 0.5).cost, toy::bowl(y));
  EXPECT_TRUE(std::ranges::equal(moves.current_point(), x));
  EXPECT_EQ(moves.propose(2, 0.5).cost, toy::bowl(std::vector<double>{0.0, 0.0, 0.5}));  // not on top of the last
  EXPECT_EQ(moves.accept(), Status::ok);
  EXPECT_TRUE(std::ranges::equal(moves.current_point(), std::vector<double>{0.0, 0.0, 0.5}));
  EXPECT_THROW((void)moves.accept(), std::logic_error);
  EXPECT_EQ(b.meter.counts().proposed, 2);
  EXPECT_EQ(b.meter.counts().accepted, 1);
  EXPECT_EQ(moves.resync().cost, toy::bowl(std::vector<double>{0.0, 0.0, 0.5}));
  EXPECT_EQ(b.meter.drift(), 0.0);
}

TEST(Meter, TakesAProposalAsTheBestPoint) {
  Bench b;
  MeteredMoves& moves = b.meter.moves();
  (void)moves.reset(b.problem.space().start());
  const Evaluation better = moves.propose(2, 0.75);
  EXPECT_EQ(b.meter.best_cost(), better.cost);
  EXPECT_EQ(b.meter.best_evaluation(), 1);
  EXPECT_TRUE(std::ranges::equal(b.meter.best_point(), std::vector<double>{-1.5, -1.5, 0.75}));
}

TEST(Meter, RefusesAStartOfTheWrongSize) {
  const toy::ToyProblem problem;
  const auto evaluator = problem.make_evaluator();
  const std::vector<double> x = {0.0};
  EXPECT_THROW(Meter(problem, *evaluator, x, {}), std::invalid_argument);
}

TEST(Trace, IsThinnedEvenlyInTheLogarithm) {
  std::vector<TracePoint> trace;
  for (std::int64_t i = 0; i <= 100000; ++i)
    trace.push_back({i, 1e-6 * static_cast<double>(i), i, 1.0 / static_cast<double>(i + 1)});
  thin_trace(trace, 2000);
  EXPECT_LE(trace.size(), 2000u);
  EXPECT_GT(trace.size(), 1000u);
  EXPECT_EQ(trace.front().evaluation, 0);
  EXPECT_EQ(trace.back().evaluation, 100000);
  double widest = 0.0;
  for (std::size_t i = 201; i < trace.size(); ++i)
    widest = std::max(widest, static_cast<double>(trace[i].evaluation) / static_cast<double>(trace[i - 1].evaluation));
  EXPECT_LT(widest, 1.02);  // 2,000 intervals over ln 1e5: 0.6 % each
  EXPECT_TRUE(std::ranges::is_sorted(trace, {}, &TracePoint::evaluation));
}

// Two milliseconds in each evaluation: all of it is the problem's time, whatever asked for it.
TEST(Meter, CountsAllTimeInTheProblemAsTheProblems) {
  using namespace std::chrono_literals;
  const toy::ToyProblem problem(3, [](std::span<const double> x) {
    std::this_thread::sleep_for(2ms);
    return toy::bowl(x);
  });
  const auto evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), {});
  const double before = meter.evaluation_seconds();
  MeteredMoves& moves = meter.moves();
  ASSERT_TRUE(moves.reset(problem.space().start()).ok());
  for (int i = 0; i < 16; ++i) ASSERT_TRUE(moves.propose(0, 0.01 * i).ok());
  ASSERT_TRUE(moves.resync().ok());
  // One reset, 16 proposals, one resync; sleeping may take longer, never shorter.
  EXPECT_GE(meter.evaluation_seconds() - before, 18 * 0.002);
  EXPECT_LE(meter.evaluation_seconds(), meter.seconds_now());
}

}  // namespace
}  // namespace nodal
