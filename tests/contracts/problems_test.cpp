// SPDX-License-Identifier: GPL-3.0-or-later
// What every problem promises, whatever it is (problem.h, evaluator.h, moves.h).
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include <nodal/random.h>

#include "../support/special_numbers.h"
#include "registered.h"

namespace nodal::contracts {
namespace {

using toy::kInfinity;
using toy::kNan;

double norm(std::span<const double> v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

using Point = std::vector<double>;

class EveryProblem : public testing::TestWithParam<Sample> {
 protected:
  EveryProblem()
      : problem_(make_problem(GetParam())),
        evaluator_(problem_->make_evaluator()),
        n_(problem_->space().size()),
        m_(problem_->residual_count()),
        can_(problem_->abilities()) {}

  Point start() const { return {problem_->space().start().begin(), problem_->space().start().end()}; }
  // Around the start, a fifth of the box to each side, and off the bounds by more than a difference's steps.
  Point random_point() {
    Point x = start();
    const Space& space = problem_->space();
    for (std::size_t i = 0; i < n_; ++i) {
      const double width = space.upper()[i] - space.lower()[i];
      x[i] += random_.uniform(-0.2, 0.2) * width;
      x[i] = std::clamp(x[i], space.lower()[i] + 0.001 * width, space.upper()[i] - 0.001 * width);
    }
    return x;
  }
  double step(std::size_t i) const { return 1e-5 * (problem_->space().upper()[i] - problem_->space().lower()[i]); }

  std::shared_ptr<const Problem> problem_;
  std::unique_ptr<Evaluator> evaluator_;
  std::size_t n_, m_;
  Abilities can_;
  RandomStream random_{1995};
};

TEST_P(EveryProblem, StartsInsideItsBoxWithAFiniteCost) {
  EXPECT_GT(n_, 0u);
  EXPECT_TRUE(problem_->space().contains(start()));
  const Evaluation at_start = evaluator_->value(start());
  ASSERT_TRUE(at_start.ok());
  EXPECT_TRUE(std::isfinite(at_start.cost));
  EXPECT_GE(at_start.cost, 0.0);
  EXPECT_TRUE(std::isfinite(problem_->quality(at_start.cost)));
}

TEST_P(EveryProblem, IsTheSameInEveryEvaluatorAndOrder) {
  std::vector<Point> points;
  for (int p = 0; p < 10; ++p) points.push_back(random_point());
  std::vector<double> forward, backward(points.size());
  for (const Point& x : points) forward.push_back(evaluator_->value(x).cost);
  const auto other = problem_->make_evaluator();
  for (std::size_t p = points.size(); p-- > 0;) backward[p] = other->value(points[p]).cost;
  EXPECT_EQ(forward, backward);
}

TEST_P(EveryProblem, IsSharedByThreads) {
  std::vector<Point> points;
  for (int p = 0; p < 20; ++p) points.push_back(random_point());
  std::vector<std::vector<double>> costs(3);
  {
    std::vector<std::jthread> threads;
    for (std::vector<double>& mine : costs)
      threads.emplace_back([&] {
        const auto own = problem_->make_evaluator();
        for (const Point& x : points) mine.push_back(own->value(x).cost);
      });
  }
  EXPECT_EQ(costs[0], costs[1]);
  EXPECT_EQ(costs[0], costs[2]);
}

TEST_P(EveryProblem, LooksAtWhatIsHeldOutWithoutMovingAnything) {
  const std::size_t count = problem_->held_out().size();
  std::vector<double> errors(count), again(count), wrong(count + 1);
  const Point first = start(), second = random_point();
  const Evaluation before = evaluator_->value(first);
  const Work work = evaluator_->work();
  Point g(n_), g_after(n_);
  if (can_.gradient) {
    ASSERT_EQ(evaluator_->gradient(g), Status::ok);
  }
  const Work with_gradient = evaluator_->work();
  ASSERT_EQ(evaluator_->held_out_errors(first, errors), Status::ok);
  for (const double error : errors) EXPECT_TRUE(std::isfinite(error) && error >= 0.0) << error;
  (void)evaluator_->held_out_errors(second, again);
  EXPECT_EQ(evaluator_->work().flops, with_gradient.flops);
  EXPECT_EQ(evaluator_->work().factorizations, work.factorizations);
  if (can_.gradient) {
    ASSERT_EQ(evaluator_->gradient(g_after), Status::ok);
    EXPECT_EQ(g, g_after);
  }
  EXPECT_EQ(evaluator_->value(first).cost, before.cost);
  ASSERT_EQ(problem_->make_evaluator()->held_out_errors(first, again), Status::ok);
  EXPECT_EQ(errors, again);
  EXPECT_THROW((void)evaluator_->held_out_errors(first, wrong), std::logic_error);
}

TEST_P(EveryProblem, RefusesSpansOfTheWrongSize) {
  Point right = start(), wrong(n_ + 1, 0.0), r(m_), short_r(m_ + 1), jacobian(m_ * n_), short_jacobian(m_ * n_ + 1);
  EXPECT_THROW((void)evaluator_->value(wrong), std::logic_error);
  EXPECT_THROW((void)evaluator_->value(Point(n_ - 1)), std::logic_error);
  EXPECT_THROW((void)evaluator_->audit(wrong), std::logic_error);
  ASSERT_TRUE(evaluator_->value(right).ok());
  if (can_.gradient) {
    EXPECT_THROW((void)evaluator_->value_and_gradient(right, wrong), std::logic_error);
    EXPECT_THROW((void)evaluator_->gradient(wrong), std::logic_error);
  }
  if (can_.residuals) {
    EXPECT_THROW((void)evaluator_->residuals(right, short_r), std::logic_error);
    EXPECT_THROW((void)evaluator_->residuals_and_jacobian(right, r, short_jacobian), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian(short_jacobian), std::logic_error);
  }
  if (can_.jacobian_products) {
    EXPECT_THROW((void)evaluator_->jacobian_product(wrong, r), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian_product(right, short_r), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian_transposed_product(short_r, right), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian_transposed_product(r, wrong), std::logic_error);
  }
  if (Moves* moves = evaluator_->moves()) {
    EXPECT_THROW((void)moves->reset(wrong), std::logic_error);
    ASSERT_TRUE(moves->reset(right).ok());
    EXPECT_THROW((void)moves->propose(n_, 0.0), std::logic_error);
  }
}

TEST_P(EveryProblem, RefusesWhatItCannotDo) {
  Point x = start(), g(n_), r(m_ + 1), jacobian((m_ + 1) * n_);
  ASSERT_TRUE(evaluator_->value(x).ok());
  if (!can_.gradient) {
    EXPECT_THROW((void)evaluator_->value_and_gradient(x, g), std::logic_error);
    EXPECT_THROW((void)evaluator_->gradient(g), std::logic_error);
  }
  if (!can_.residuals) {
    EXPECT_EQ(m_, 0u);
    EXPECT_THROW((void)evaluator_->residuals(x, r), std::logic_error);
    EXPECT_THROW((void)evaluator_->residuals_and_jacobian(x, r, jacobian), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian(jacobian), std::logic_error);
  }
  if (!can_.jacobian_products) {
    EXPECT_THROW((void)evaluator_->jacobian_product(g, r), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian_transposed_product(r, g), std::logic_error);
  }
  EXPECT_EQ(evaluator_->moves() != nullptr, can_.moves);
}

TEST_P(EveryProblem, RefusesDerivativesWhereNothingWasEvaluated) {
  Point g(n_), r(m_), jacobian(m_ * n_);
  if (can_.gradient) {
    EXPECT_THROW((void)evaluator_->gradient(g), std::logic_error);
  }
  if (can_.residuals) {
    EXPECT_THROW((void)evaluator_->jacobian(jacobian), std::logic_error);
  }
  if (can_.jacobian_products) {
    EXPECT_THROW((void)evaluator_->jacobian_product(g, r), std::logic_error);
    EXPECT_THROW((void)evaluator_->jacobian_transposed_product(r, g), std::logic_error);
  }
}

TEST_P(EveryProblem, SaysThatAPointIsNoNumber) {
  const double good = evaluator_->value(start()).cost;
  for (const double bad : {kNan, kInfinity}) {
    for (const std::size_t i : {std::size_t{0}, n_ / 2, n_ - 1}) {
      Point x = start(), g(n_), r(m_), jacobian(m_ * n_);
      x[i] = bad;
      EXPECT_EQ(evaluator_->value(x).status, Status::invalid_input);
      EXPECT_EQ(evaluator_->audit(x).status, Status::invalid_input);
      if (can_.gradient) {
        EXPECT_EQ(evaluator_->value_and_gradient(x, g).status, Status::invalid_input);
      }
      if (can_.residuals) {
        EXPECT_EQ(evaluator_->residuals_and_jacobian(x, r, jacobian).status, Status::invalid_input);
      }
      if (Moves* moves = evaluator_->moves()) {
        ASSERT_TRUE(moves->reset(start()).ok());
        EXPECT_EQ(moves->propose(i, bad).status, Status::invalid_input);
        EXPECT_THROW((void)moves->accept(), std::logic_error);
        EXPECT_EQ(moves->reset(x).status, Status::invalid_input);
      }
    }
  }
  EXPECT_EQ(evaluator_->value(start()).cost, good);  // nothing of it stays behind
}

// Differences of fourth order with a step of 1e-5 of the box. Truncation: below 1e-8 for whatever varies over more than
// a thousandth of the box; rounding: 1e-14 of the cost over 1e-5. Both far below 1e-6 of a gradient that matters.
TEST_P(EveryProblem, HasTheGradientOfItsDifferences) {
  if (!can_.gradient) GTEST_SKIP() << "no gradient";
  for (int p = 0; p < 3; ++p) {
    const Point x = random_point();
    Point g(n_), again(n_);
    const Evaluation with_gradient = evaluator_->value_and_gradient(x, g);
    ASSERT_TRUE(with_gradient.ok());
    ASSERT_EQ(evaluator_->gradient(again), Status::ok);
    EXPECT_EQ(g, again);
    EXPECT_EQ(problem_->make_evaluator()->value(x).cost, with_gradient.cost);
    for (std::size_t i = 0; i < n_; ++i) {
      const auto at = [&](double steps) {
        Point y = x;
        y[i] += steps * step(i);
        return evaluator_->audit(y).cost;
      };
      const double difference = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step(i));
      EXPECT_NEAR(g[i], difference, 1e-6 * norm(g)) << problem_->space().name(i);
    }
  }
}

TEST_P(EveryProblem, HasResidualsThatMakeItsCost) {
  if (!can_.residuals) GTEST_SKIP() << "no residuals";
  for (int p = 0; p < 10; ++p) {
    const Point x = random_point();
    Point r(m_), same(m_), jacobian(m_ * n_), g(n_), expected(n_, 0.0);
    const Evaluation at_x = evaluator_->residuals_and_jacobian(x, r, jacobian);
    ASSERT_TRUE(at_x.ok());
    // The same squares, summed in another order.
    EXPECT_NEAR(0.5 * norm(r) * norm(r), at_x.cost, 1e-12 * at_x.cost);
    ASSERT_TRUE(evaluator_->residuals(x, same).ok());
    EXPECT_EQ(r, same);
    if (!can_.gradient) continue;
    ASSERT_TRUE(evaluator_->value_and_gradient(x, g).ok());
    for (std::size_t a = 0; a < m_; ++a)
      for (std::size_t i = 0; i < n_; ++i) expected[i] += jacobian[a * n_ + i] * r[a];
    for (std::size_t i = 0; i < n_; ++i) EXPECT_NEAR(g[i], expected[i], 1e-10 * norm(g));
  }
}

// As for the gradient, row by row; a row that is nearly nothing is compared on the scale of all residuals.
TEST_P(EveryProblem, HasTheJacobianOfItsDifferences) {
  if (!can_.residuals) GTEST_SKIP() << "no residuals";
  const Point x = random_point();
  Point r(m_), jacobian(m_ * n_);
  ASSERT_TRUE(evaluator_->residuals_and_jacobian(x, r, jacobian).ok());
  for (std::size_t i = 0; i < n_; ++i) {
    const auto at = [&](double steps) {
      Point y = x, residuals(m_);
      y[i] += steps * step(i);
      EXPECT_TRUE(evaluator_->residuals(y, residuals).ok());
      return residuals;
    };
    const Point p1 = at(1), m1 = at(-1), p2 = at(2), m2 = at(-2);
    for (std::size_t a = 0; a < m_; ++a) {
      const double difference = (8.0 * (p1[a] - m1[a]) - (p2[a] - m2[a])) / (12.0 * step(i));
      const double row = norm(std::span(jacobian).subspan(a * n_, n_));
      EXPECT_NEAR(jacobian[a * n_ + i], difference, 1e-6 * std::max(row, 1e-3 * norm(r))) << a << ", " << i;
    }
  }
}

TEST_P(EveryProblem, HasProductsOfItsJacobian) {
  if (!can_.jacobian_products) GTEST_SKIP() << "no Jacobian products";
  for (int p = 0; p < 3; ++p) {
    const Point x = random_point();
    Point r(m_), jacobian(m_ * n_), v(n_), w(m_), jv(m_), jtw(n_), jv_expected(m_, 0.0), jtw_expected(n_, 0.0);
    ASSERT_TRUE(evaluator_->residuals_and_jacobian(x, r, jacobian).ok());
    for (double& vi : v) vi = random_.uniform(-1.0, 1.0);
    for (double& wi : w) wi = random_.uniform(-1.0, 1.0);
    ASSERT_EQ(evaluator_->jacobian_product(v, jv), Status::ok);
    ASSERT_EQ(evaluator_->jacobian_transposed_product(w, jtw), Status::ok);
    for (std::size_t a = 0; a < m_; ++a)
      for (std::size_t i = 0; i < n_; ++i) {
        jv_expected[a] += jacobian[a * n_ + i] * v[i];
        jtw_expected[i] += jacobian[a * n_ + i] * w[a];
      }
    // The same numbers, summed in another order.
    for (std::size_t a = 0; a < m_; ++a) EXPECT_NEAR(jv[a], jv_expected[a], 1e-10 * norm(jv_expected));
    for (std::size_t i = 0; i < n_; ++i) EXPECT_NEAR(jtw[i], jtw_expected[i], 1e-10 * norm(jtw_expected));
  }
}

TEST_P(EveryProblem, RepeatsNothingForADerivativeAtTheLastPoint) {
  const Point x = random_point();
  Point g(n_), r(m_), jacobian(m_ * n_), w(m_, 1.0);
  ASSERT_TRUE(evaluator_->value(x).ok());
  const std::int64_t before = evaluator_->work().factorizations;
  if (can_.gradient) {
    ASSERT_TRUE(evaluator_->value_and_gradient(x, g).ok());
  }
  if (can_.residuals) {
    ASSERT_TRUE(evaluator_->residuals_and_jacobian(x, r, jacobian).ok());
  }
  if (can_.jacobian_products) {
    ASSERT_EQ(evaluator_->jacobian_product(x, r), Status::ok);
    ASSERT_EQ(evaluator_->jacobian_transposed_product(w, g), Status::ok);
  }
  EXPECT_EQ(evaluator_->work().factorizations, before);
}

TEST_P(EveryProblem, PricesMovesLikeFullEvaluations) {
  Moves* moves = evaluator_->moves();
  if (!moves) GTEST_SKIP() << "no moves";
  EXPECT_EQ(evaluator_->moves(), moves);
  Point x = random_point();
  const auto full = problem_->make_evaluator();
  ASSERT_TRUE(moves->reset(x).ok());
  for (int step = 0; step < 200; ++step) {
    Point y = x;
    const std::size_t i = random_.index(n_);
    y[i] = random_point()[i];
    const Evaluation priced = moves->propose(i, y[i]), expected = full->audit(y);
    ASSERT_TRUE(priced.ok());
    EXPECT_NEAR(priced.cost, expected.cost, 1e-10 * expected.cost);
    if (step % 3 == 0) {
      ASSERT_EQ(moves->accept(), Status::ok);
      EXPECT_THROW((void)moves->accept(), std::logic_error);
      x = y;
    }
    ASSERT_TRUE(std::ranges::equal(moves->current_point(), x));
  }
  const double fresh = full->audit(x).cost;
  EXPECT_NEAR(moves->resync().cost, fresh, 1e-10 * fresh);
}

// From anywhere in the box downhill, with steps as wide as the box at first: prices are right relative to what the cost
// is now, whatever it was at the start. 1e-9 is the promise; where refining a plain evaluation moves more, ten times
// that.
TEST_P(EveryProblem, PricesMovesRightOnTheWayDown) {
  Moves* moves = evaluator_->moves();
  if (!moves) GTEST_SKIP() << "no moves";
  const auto full = problem_->make_evaluator();
  const Space& space = problem_->space();
  for (int start = 0; start < 3; ++start) {
    Point x(n_);
    for (std::size_t i = 0; i < n_; ++i) x[i] = random_.uniform(space.lower()[i], space.upper()[i]);
    const Evaluation began = moves->reset(x);
    ASSERT_TRUE(began.ok());
    double cost = began.cost;
    for (int step = 0; step < 3000; ++step) {
      const std::size_t i = random_.index(n_);
      const double width = (space.upper()[i] - space.lower()[i]) * std::exp(-step / 500.0);
      Point y = x;
      y[i] = std::clamp(x[i] + random_.uniform(-width, width), space.lower()[i], space.upper()[i]);
      const Evaluation priced = moves->propose(i, y[i]);
      ASSERT_TRUE(priced.ok());
      if (step % 25 == 0) {
        const double exact = full->audit(y).cost, r = std::sqrt(2.0 * std::abs(exact));
        const double moved = 10.0 * full->health().error_estimate.value_or(0.0) * (1.0 + r);
        ASSERT_NEAR(priced.cost, exact, 1e-9 * std::max(cost, exact) + r * moved + 0.5 * moved * moved) << step;
      }
      if (priced.cost > 1.02 * cost) continue;
      ASSERT_EQ(moves->accept(), Status::ok);
      x = y;
      cost = priced.cost;
    }
  }
  EXPECT_EQ(moves->contradictions(), 0);
}

// The evaluator's last point and its walk know nothing of each other.
TEST_P(EveryProblem, KeepsItsLastPointThroughAWalk) {
  if (!can_.moves || !can_.gradient) GTEST_SKIP() << "no moves or no gradient";
  const Point x = random_point(), other = random_point();
  Point g(n_), after(n_);
  ASSERT_TRUE(evaluator_->value_and_gradient(x, g).ok());
  ASSERT_TRUE(evaluator_->moves()->reset(other).ok());
  ASSERT_TRUE(evaluator_->moves()->propose(0, x[0]).ok());
  ASSERT_EQ(evaluator_->moves()->accept(), Status::ok);
  ASSERT_EQ(evaluator_->gradient(after), Status::ok);
  EXPECT_EQ(g, after);
}

TEST_P(EveryProblem, HasAQualityThatRisesWithTheCost) {
  double previous = problem_->quality(0.0);
  for (double cost = 1e-12; cost < 1e6; cost *= 1.7) {
    const double quality = problem_->quality(cost);
    EXPECT_GT(quality, previous) << cost;
    previous = quality;
  }
}

TEST_P(EveryProblem, IsNowhereBetterThanItsKnownOptimum) {
  const std::optional<KnownOptimum> known = problem_->known_optimum();
  if (!known) GTEST_SKIP() << "no optimum known";
  EXPECT_FALSE(known->origin.empty());
  if (!known->x.empty()) {
    EXPECT_TRUE(problem_->space().contains(known->x));
    const Evaluation there = evaluator_->audit(known->x);
    ASSERT_TRUE(there.ok());
    EXPECT_NEAR(problem_->quality(there.cost), known->quality, 1e-12 * std::max(1.0, known->quality));
  }
  for (int p = 0; p < 100; ++p) EXPECT_GE(problem_->quality(evaluator_->value(random_point()).cost), known->quality);
}

TEST_P(EveryProblem, ExplainsItself) {
  EXPECT_FALSE(problem_->stages().empty());
  for (const Stage& stage : problem_->stages()) {
    EXPECT_FALSE(stage.name.empty());
    EXPECT_FALSE(stage.detail.empty()) << stage.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryProblem, testing::ValuesIn(samples()),
                         [](const auto& sample) { return sample.param.name; });

}  // namespace
}  // namespace nodal::contracts
