// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/meter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include <nodal/agreement.h>

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

// Prices at a tenth of the cost, until told to be honest; finds itself refuted when told so.
class FalseMoves final : public Moves {
 public:
  Evaluation reset(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return {Status::ok, toy::bowl(x_)};
  }
  Evaluation propose(std::size_t i, double value) override {
    proposed_ = x_;
    proposed_[i] = value;
    return {Status::ok, (honest ? 1.0 : 0.1) * toy::bowl(proposed_)};
  }
  [[nodiscard]] Status accept() override {
    x_ = proposed_;
    if (refuted) ++refutations_;
    return Status::ok;
  }
  [[nodiscard]] std::span<const double> current_point() const override { return x_; }
  Evaluation resync() override { return {Status::ok, toy::bowl(x_)}; }
  [[nodiscard]] std::int64_t contradictions() const override { return refutations_; }

  bool honest = false, refuted = false;

 private:
  std::vector<double> x_, proposed_;
  std::int64_t refutations_ = 0;
};

class FalsePricing final : public Evaluator {
 public:
  Evaluation value(std::span<const double> x) override { return {Status::ok, toy::bowl(x)}; }
  [[nodiscard]] Moves* moves() override { return &false_moves; }
  FalseMoves false_moves;
};

// Walks from the start, (−1.5, −1.5, −1.5), to the bowl's optimum, (0.25, 0.5, 0.75), coordinate by coordinate.
struct FalseWalk {
  FalseWalk() { EXPECT_TRUE(moves.reset(problem.space().start()).ok()); }
  Evaluation step(std::size_t i, double value) {
    const Evaluation priced = moves.propose(i, value);
    if (priced.ok()) {
      EXPECT_EQ(moves.accept(), Status::ok);
    }
    return priced;
  }
  void expect_best_as_evaluated() const {
    EXPECT_EQ(meter.best_cost(), toy::bowl(meter.best_point()));
    EXPECT_EQ(meter.trace().back().evaluation, meter.best_evaluation());
    EXPECT_EQ(meter.trace().back().quality, problem.quality(meter.best_cost()));
    for (std::size_t i = 1; i < meter.trace().size(); ++i)
      EXPECT_LT(meter.trace()[i].quality, meter.trace()[i - 1].quality);
  }
  toy::ToyProblem problem;
  FalsePricing evaluator;
  Meter meter{problem, evaluator, problem.space().start(), {}};
  MeteredMoves& moves = meter.moves();
};

TEST(RefutedPrices, TakeTheirBestBackAtAResync) {
  FalseWalk walk;
  walk.evaluator.false_moves.honest = true;
  (void)walk.step(0, 0.25);
  walk.evaluator.false_moves.honest = false;
  (void)walk.step(0, -1.5);  // worse than that, and priced as better
  (void)walk.step(1, 0.0);   // better than the start, not as good as priced
  EXPECT_EQ(walk.meter.best_evaluation(), 3);
  EXPECT_LT(walk.meter.best_cost(), toy::bowl(walk.meter.best_point()));
  const double fresh = walk.moves.resync().cost;
  EXPECT_EQ(walk.moves.current_cost(), fresh);
  EXPECT_EQ(walk.meter.best_evaluation(), 3);  // at its true cost
  walk.expect_best_as_evaluated();
  EXPECT_EQ(walk.meter.trace().size(), 2u);  // start and best: nothing confirmed what was between
  EXPECT_EQ(walk.meter.moves_report()->taken_back, 1);
  EXPECT_NEAR(*walk.meter.drift(), 0.9, 1e-12);
}

TEST(RefutedPrices, LeaveTheStartAsTheBestWhereNothingWasBetter) {
  FalseWalk walk;
  (void)walk.step(0, -2.0);
  EXPECT_EQ(walk.meter.best_evaluation(), 1);
  (void)walk.moves.resync();
  EXPECT_EQ(walk.meter.best_evaluation(), 0);
  EXPECT_TRUE(std::ranges::equal(walk.meter.best_point(), walk.problem.space().start()));
  walk.expect_best_as_evaluated();
  // From here on true improvements are improvements.
  walk.evaluator.false_moves.honest = true;
  (void)walk.step(0, -1.0);
  EXPECT_EQ(walk.meter.best_evaluation(), 2);
  walk.expect_best_as_evaluated();
}

TEST(RefutedPrices, EndNoTrialAtItsTarget) {
  FalseWalk walk;
  walk.meter.set_target(1.0);  // √(Σ (x − c)²); the start has 3.5, priced at 0.1 of the cost 1.1
  (void)walk.step(0, 0.25);    // 3.0, priced as 0.96
  EXPECT_FALSE(walk.meter.spent());
  walk.expect_best_as_evaluated();
  (void)walk.step(1, 0.5);  // 2.25, priced as 0.7
  EXPECT_FALSE(walk.meter.spent());
  (void)walk.step(2, 0.5);  // 0.25
  EXPECT_EQ(walk.meter.stop(), Stop::target);
  walk.expect_best_as_evaluated();
  EXPECT_EQ(walk.meter.counts().evaluations, 3);
}

TEST(RefutedPrices, AreLookedAtAgainWhenTheWalkFindsOut) {
  FalseWalk walk;
  walk.evaluator.false_moves.refuted = true;
  (void)walk.step(0, -2.0);
  EXPECT_EQ(walk.meter.best_evaluation(), 0);
  EXPECT_EQ(walk.moves.current_cost(), toy::bowl(walk.moves.current_point()));
  walk.expect_best_as_evaluated();
}

TEST(RefutedPrices, AreLookedAtAgainWhereAWalkReturnsToTheBest) {
  FalseWalk walk;
  (void)walk.step(0, -2.0);
  const std::vector<double> best(walk.meter.best_point().begin(), walk.meter.best_point().end());
  ASSERT_TRUE(walk.moves.reset(best).ok());
  EXPECT_EQ(walk.meter.best_evaluation(), 0);
  walk.expect_best_as_evaluated();
}

TEST(RefutedPrices, ThatHoldChangeNothing) {
  FalseWalk walk;
  walk.evaluator.false_moves.honest = true;
  walk.meter.set_target(0.3);
  for (const auto& [i, value] : std::vector<std::pair<std::size_t, double>>{{0, 0.0}, {1, 0.0}, {2, 0.0}, {2, 0.75}})
    (void)walk.step(i, value);
  (void)walk.moves.resync();
  EXPECT_EQ(walk.meter.trace().size(), 5u);
  EXPECT_EQ(walk.meter.stop(), Stop::none);  // 0.56
  EXPECT_FALSE(walk.meter.moves_report().has_value());
  EXPECT_EQ(walk.meter.drift(), 0.0);
}

TEST(Meter, TakesNoPointOutsideTheBox) {
  Bench b({}, [](std::span<const double> x) { return -x[0]; });  // in [−2, 3]³
  const std::vector<double> inside = {2.0, 0.0, 0.0}, outside = {3.5, 0.0, 0.0}, nowhere = {2.5, std::nan(""), 0.0};
  EXPECT_TRUE(b.meter.value(inside).ok());
  EXPECT_FALSE(b.meter.outside().has_value());
  EXPECT_TRUE(b.meter.value(outside).ok());
  EXPECT_TRUE(b.meter.value(nowhere).ok());
  (void)b.meter.moves().reset(inside);
  EXPECT_TRUE(b.meter.moves().propose(0, 4.0).ok());
  EXPECT_TRUE(std::ranges::equal(b.meter.best_point(), inside));
  EXPECT_EQ(b.meter.best_evaluation(), 1);
  ASSERT_TRUE(b.meter.outside().has_value());
  EXPECT_EQ(b.meter.outside()->evaluation, 2);
  EXPECT_EQ(b.meter.outside()->coordinate, 0u);
  EXPECT_EQ(b.meter.outside()->value, 3.5);
}

TEST(Agreement, IsRelativeToTheCostAndToWhatARaceCanTell) {
  EXPECT_DOUBLE_EQ(relative_drift(1.5, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(relative_drift(0.5e-3, 1e-3), 0.5);
  EXPECT_LE(relative_drift(3e-32, 1e-32), 1e-11);  // rounding of a perfect fit
  EXPECT_FALSE(contradicts(1.0, 1.0));
  EXPECT_FALSE(contradicts(1.0 - 1e-7, 1.0));
  EXPECT_TRUE(contradicts(1.0 - 2e-6, 1.0));
  EXPECT_TRUE(contradicts(1e-4 * (1.0 - 2e-6), 1e-4));
  EXPECT_FALSE(contradicts(2.0, 1.0));  // seen as worse than it is
  EXPECT_FALSE(contradicts(1e-34, 8e-34));
  EXPECT_TRUE(contradicts(1e-34, 1e-19));
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

TEST(Meter, RefusesPointsOfAnotherSize) {
  Bench b;
  const std::vector<double> less(b.problem.space().size() - 1, 0.0), more(b.problem.space().size() + 1, 0.0);
  EXPECT_THROW((void)b.meter.value(less), std::invalid_argument);
  EXPECT_THROW((void)b.meter.value(more), std::invalid_argument);
}

}  // namespace
}  // namespace nodal
