// SPDX-License-Identifier: GPL-3.0-or-later
// Values at points computed by hand, derivatives against differences.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <nodal/random.h>

#include "analytic.h"

namespace nodal::analytic {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

double norm(std::span<const double> v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

struct KnownValue {
  std::string kind;
  std::vector<double> x;
  double quality = 0.0;
};

TEST(Functions, HaveTheirKnownValues) {
  const std::vector<KnownValue> known = {
      {"sphere", {1.0, 2.0, 3.0}, 14.0},
      {"rosenbrock", {-1.2, 1.0}, 24.2},  // 100 · 0.44² + 2.2²
      {"rosenbrock", {0.0, 0.0, 0.0}, 2.0},
      {"rosenbrock", {2.0, 3.0, 4.0}, 2605.0},            // 100 · (1² + 5²) + 1² + 2²
      {"powell-singular", {3.0, -1.0, 0.0, 1.0}, 215.0},  // 7² + 5 · 1² + 1² + 10 · 2⁴, as in the literature
      {"powell-singular", {3.0, -1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0}, 226.0},
      {"brown-almost-linear", {0.5, 0.5, 0.5}, 8.765625},  // 2 · 2² + (7/8)²
      {"brown-almost-linear", {0.0, 0.0, 0.0, 5.0}, 1.0},  // the local minimum that Moré et al. give
      {"rastrigin", {1.0, 1.0}, 2.0},
      {"rastrigin", {0.5}, 20.25},
      {"ackley", {1.0, 1.0}, 20.0 * (1.0 - std::exp(-0.2))},
      {"ackley", {0.5}, 20.0 * (1.0 - std::exp(-0.1)) + std::numbers::e - std::exp(-1.0)},
      {"griewank", {pi}, pi * pi / 4000.0 + 2.0},
      {"griewank", {0.0, sqrt2 * pi}, 2.0 * pi * pi / 4000.0 + 2.0},
      {"griewank", {0.5 * pi, 17.0}, (0.25 * pi * pi + 289.0) / 4000.0 + 1.0},
      {"levy", {5.0}, 1.0},
      {"levy", {3.0}, 1.25},
      {"levy", {5.0, 5.0}, 2.0 + 10.0 * std::pow(std::sin(1.0), 2)},
  };
  for (const KnownValue& k : known) {
    const auto problem = make_function(k.kind, k.x.size());
    const Evaluation result = problem->make_evaluator()->value(k.x);
    ASSERT_TRUE(result.ok()) << k.kind;
    // A few roundings of numbers as large as the value (for sines at multiples of π: of 20).
    EXPECT_NEAR(problem->quality(result.cost), k.quality, 1e-14 * std::max(k.quality, 20.0)) << k.kind;
  }
}

class EveryFunction : public testing::TestWithParam<std::string> {
 protected:
  static std::vector<std::size_t> dimensions() {
    if (GetParam() == "powell-singular") return {4, 12};
    if (GetParam() == "rosenbrock") return {2, 3, 10};
    return {1, 2, 10};
  }
  std::vector<double> random_point(const Space& space) {
    std::vector<double> x(space.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = random_.uniform(space.lower()[i], space.upper()[i]);
    return x;
  }
  RandomStream random_{1981};
};

TEST_P(EveryFunction, IsZeroAtItsKnownOptimumAndNowhereLess) {
  for (const std::size_t n : dimensions()) {
    const auto problem = make_function(GetParam(), n);
    const std::optional<KnownOptimum> known = problem->known_optimum();
    ASSERT_TRUE(known.has_value());
    EXPECT_EQ(known->quality, 0.0);
    const auto evaluator = problem->make_evaluator();
    EXPECT_EQ(evaluator->value(known->x).cost, 0.0);  // the formulas have no rounding there
    std::vector<double> gradient(n);
    ASSERT_EQ(evaluator->gradient(gradient), Status::ok);
    EXPECT_EQ(norm(gradient), 0.0);
    for (int point = 0; point < 1000; ++point) EXPECT_GE(evaluator->value(random_point(problem->space())).cost, 0.0);
  }
}

// Differences of fourth order with step 1e-3: the error of the fastest wave, period 1/2, is (4π · 1e-3)⁴/30 ~ 1e-9 of
// the gradient; rounding is 1e-13 of the value, which is at most 1e4 times the gradient: both below 1e-6.
constexpr double kStep = 1e-3;

TEST_P(EveryFunction, HasTheGradientOfItsDifferences) {
  for (const std::size_t n : dimensions()) {
    const auto problem = make_function(GetParam(), n);
    const auto evaluator = problem->make_evaluator();
    for (int point = 0; point < 20; ++point) {
      const std::vector<double> x = random_point(problem->space());
      std::vector<double> gradient(n);
      ASSERT_TRUE(evaluator->value_and_gradient(x, gradient).ok());
      for (std::size_t i = 0; i < n; ++i) {
        const auto at = [&](double steps) {
          std::vector<double> y = x;
          y[i] += steps * kStep;
          return evaluator->value(y).cost;
        };
        const double difference = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * kStep);
        EXPECT_NEAR(gradient[i], difference, 1e-6 * norm(gradient)) << "coordinate " << i << " of " << n;
      }
    }
  }
}

TEST_P(EveryFunction, HasTheJacobianOfItsDifferences) {
  for (const std::size_t n : dimensions()) {
    const auto problem = make_function(GetParam(), n);
    if (!problem->abilities().residuals) return;
    const auto evaluator = problem->make_evaluator();
    const std::size_t m = problem->residual_count();
    for (int point = 0; point < 20; ++point) {
      const std::vector<double> x = random_point(problem->space());
      std::vector<double> r(m), jacobian(m * n);
      ASSERT_TRUE(evaluator->residuals_and_jacobian(x, r, jacobian).ok());
      for (std::size_t i = 0; i < n; ++i) {
        const auto at = [&](double steps) {
          std::vector<double> y = x, residuals(m);
          y[i] += steps * kStep;
          EXPECT_TRUE(evaluator->residuals(y, residuals).ok());
          return residuals;
        };
        const auto p1 = at(1), m1 = at(-1), p2 = at(2), m2 = at(-2);
        for (std::size_t row = 0; row < m; ++row) {
          const double difference = (8.0 * (p1[row] - m1[row]) - (p2[row] - m2[row])) / (12.0 * kStep);
          const double scale = norm(std::span(jacobian).subspan(row * n, n));
          EXPECT_NEAR(jacobian[row * n + i], difference, 1e-6 * scale) << "residual " << row << ", coordinate " << i;
        }
      }
    }
  }
}

TEST_P(EveryFunction, RefusesAPointThatIsNoNumber) {
  const auto problem = make_function(GetParam(), dimensions().back());
  const auto evaluator = problem->make_evaluator();
  for (std::size_t i = 0; i < problem->space().size(); ++i) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      std::vector<double> x(problem->space().start().begin(), problem->space().start().end());
      x[i] = bad;
      EXPECT_EQ(evaluator->value(x).status, Status::invalid_input);
    }
  }
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const ProblemDescription& problem : functions().problems()) names.push_back(problem.kind);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Analytic, EveryFunction, testing::ValuesIn(kinds()), [](const auto& p) {
  std::string name = p.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
});

// An almost flat direction: at the optimum the blocks' last two residuals lose their slope.
TEST(PowellSingular, HasAJacobianOfRankTwoAtItsOptimum) {
  const auto problem = make_function("powell-singular", 4);
  const auto evaluator = problem->make_evaluator();
  std::vector<double> r(4), jacobian(16);
  ASSERT_TRUE(evaluator->residuals_and_jacobian(std::vector<double>(4, 0.0), r, jacobian).ok());
  EXPECT_GT(norm(std::span(jacobian).subspan(0, 8)), 1.0);
  EXPECT_EQ(norm(std::span(jacobian).subspan(8, 8)), 0.0);
}

// Products of other coordinates must not be formed by dividing.
TEST(BrownAlmostLinear, HasAJacobianWhereCoordinatesAreZero) {
  const auto problem = make_function("brown-almost-linear", 3);
  const auto evaluator = problem->make_evaluator();
  std::vector<double> r(3), jacobian(9);
  ASSERT_TRUE(evaluator->residuals_and_jacobian(std::vector<double>{0.0, 2.0, 3.0}, r, jacobian).ok());
  EXPECT_EQ(jacobian, (std::vector<double>{2, 1, 1, 1, 2, 1, 6, 0, 0}));
}

// 10^308 is the end: ten coordinates of 1e31 multiply to 1e310.
TEST(BrownAlmostLinear, SaysWhenItsProductOverflows) {
  const auto evaluator = make_function("brown-almost-linear", 10)->make_evaluator();
  EXPECT_EQ(evaluator->value(std::vector<double>(10, 1e31)).status, Status::invalid_input);
}

}  // namespace
}  // namespace nodal::analytic
