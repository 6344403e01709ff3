// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives and moves of the elastic problem against differences and full evaluations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <nodal/random.h>

#include "../block.h"

namespace nodal::elastic {
namespace {

// k spread over four decades: x uniform within ± ln 100 of 1.
std::vector<double> random_point(const Space& space, RandomStream& random) {
  std::vector<double> x(space.size());
  for (double& xi : x) xi = random.uniform(-std::log(100.0), std::log(100.0));
  return x;
}

double norm(std::span<const double> v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

constexpr const char* kWide = "[1e-6, 1e6]";

struct Variant {
  const char* name;
  std::function<std::shared_ptr<const ElasticProblem>()> make;
};

Variant plate(const char* name, PlateOptions options) {
  options.bounds = kWide;
  return {name, [options] { return make_plate(options); }};
}
Variant block(const char* name, BlockOptions options) {
  options.bounds = kWide;
  return {name, [options] { return make_block(options); }};
}

class Derivatives : public testing::TestWithParam<Variant> {
 protected:
  Derivatives() : problem_(GetParam().make()), evaluator_(problem_->make_evaluator()) {}

  std::shared_ptr<const ElasticProblem> problem_;
  std::unique_ptr<Evaluator> evaluator_;
  RandomStream random_{2024};
};

// Differences of fourth order with step 1e-3 in ln k: truncation ~1e-12, rounding ~1e-12, both far below 1e-6.
TEST_P(Derivatives, GradientAgreesWithDifferences) {
  const std::size_t n = problem_->space().size();
  for (int point = 0; point < 5; ++point) {
    const std::vector<double> x = random_point(problem_->space(), random_);
    std::vector<double> gradient(n), differences(n);
    ASSERT_TRUE(evaluator_->value_and_gradient(x, gradient).ok());
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](double step) {
        std::vector<double> y = x;
        y[i] += step;
        return evaluator_->audit(y).cost;
      };
      constexpr double h = 1e-3;
      differences[i] = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
    }
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(gradient[i], differences[i], 1e-6 * norm(gradient)) << i;
  }
}

TEST_P(Derivatives, JacobianAndItsProductsAgreeWithDifferences) {
  const std::size_t n = problem_->space().size(), m = problem_->residual_count();
  for (int point = 0; point < 3; ++point) {
    const std::vector<double> x = random_point(problem_->space(), random_);
    std::vector<double> r(m), jacobian(m * n), column(m);
    const Evaluation at_x = evaluator_->residuals_and_jacobian(x, r, jacobian);
    ASSERT_TRUE(at_x.ok());
    EXPECT_NEAR(0.5 * norm(r) * norm(r), at_x.cost, 1e-13 * at_x.cost);

    std::vector<double> v(n), w(m), jv(m), jtw(n), jv_expected(m, 0.0), jtw_expected(n, 0.0);
    for (double& e : v) e = random_.uniform(-1, 1);
    for (double& e : w) e = random_.uniform(-1, 1);
    ASSERT_EQ(evaluator_->jacobian_product(v, jv), Status::ok);
    ASSERT_EQ(evaluator_->jacobian_transposed_product(w, jtw), Status::ok);
    for (std::size_t a = 0; a < m; ++a)
      for (std::size_t i = 0; i < n; ++i) {
        jv_expected[a] += jacobian[a * n + i] * v[i];
        jtw_expected[i] += jacobian[a * n + i] * w[a];
      }
    // The same numbers, summed in another order.
    for (std::size_t a = 0; a < m; ++a) EXPECT_NEAR(jv[a], jv_expected[a], 1e-10 * norm(jv));
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(jtw[i], jtw_expected[i], 1e-10 * norm(jtw));

    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](double step) {
        std::vector<double> y = x, residuals(m);
        y[i] += step;
        EXPECT_TRUE(evaluator_->residuals(y, residuals).ok());
        return residuals;
      };
      constexpr double h = 1e-3;
      const auto p1 = at(h), m1 = at(-h), p2 = at(2 * h), m2 = at(-2 * h);
      double error = 0.0, size = 0.0;
      for (std::size_t a = 0; a < m; ++a) {
        const double difference = (8.0 * (p1[a] - m1[a]) - (p2[a] - m2[a])) / (12.0 * h);
        error = std::max(error, std::abs(difference - jacobian[a * n + i]));
        size = std::max(size, std::abs(jacobian[a * n + i]));
      }
      // Columns of springs that carry next to nothing are compared on the Jacobian's own scale.
      EXPECT_LE(error, 1e-6 * std::max(size, 1e-3 * norm(r))) << "column " << i;
    }
  }
}

TEST_P(Derivatives, ComeFromTheLastPointsFactorization) {
  const std::vector<double> x = random_point(problem_->space(), random_);
  std::vector<double> gradient(x.size()), r(problem_->residual_count()), jacobian(r.size() * x.size());
  ASSERT_TRUE(evaluator_->value(x).ok());
  const std::int64_t before = evaluator_->work().factorizations;
  ASSERT_TRUE(evaluator_->value_and_gradient(x, gradient).ok());
  ASSERT_TRUE(evaluator_->residuals_and_jacobian(x, r, jacobian).ok());
  EXPECT_EQ(evaluator_->work().factorizations, before);
}

TEST_P(Derivatives, MovesArePricedLikeFullEvaluations) {
  Moves* moves = evaluator_->moves();
  ASSERT_NE(moves, nullptr);
  const auto full = problem_->make_evaluator();
  std::vector<double> x = random_point(problem_->space(), random_);
  ASSERT_NEAR(moves->reset(x).cost, full->value(x).cost, 1e-12 * full->value(x).cost);
  for (int step = 0; step < 300; ++step) {
    const std::size_t i = random_.index(x.size());
    std::vector<double> y = x;
    y[i] = std::clamp(y[i] + random_.uniform(-2.0, 2.0), problem_->space().lower()[i], problem_->space().upper()[i]);
    const Evaluation priced = moves->propose(i, y[i]);
    const Evaluation expected = full->audit(y);
    ASSERT_TRUE(priced.ok()) << to_string(priced.status) << " where a full evaluation is "
                             << to_string(expected.status);
    if (!expected.ok()) continue;  // a corner of the box, where double precision can't vouch for the digits
    // Pricing works on an unrefined equilibrium: 1e-10 of u is what the race promises, twice that of a square.
    EXPECT_NEAR(priced.cost, expected.cost, 2e-10 * expected.cost);
    if (step % 3 == 0) {
      ASSERT_EQ(moves->accept(), Status::ok);
      x = y;
    }
    ASSERT_TRUE(std::ranges::equal(moves->current_point(), x));
  }
  EXPECT_NEAR(moves->resync().cost, full->audit(x).cost, 1e-10 * full->audit(x).cost);
}

INSTANTIATE_TEST_SUITE_P(
    Variants, Derivatives,
    testing::Values(plate("edge", {}), plate("minimal", {.supports = "minimal"}),
                    plate("tied", {.parameters = "by-direction"}), plate("symmetric", {.parameters = "symmetric"}),
                    plate("strain_alternating", {.plane = "strain", .topology = "alternating", .counts = "[6, 4]"}),
                    plate("supernodal", {.solver = "supernodal"}), block("block_face_lanes", {.solver = "lanes"}),
                    block("block_face_cholmod", {.topology = "single", .solver = "simplicial"}),
                    block("block_minimal_lanes", {.counts = "[2, 3, 4]", .supports = "minimal", .solver = "lanes"}),
                    block("block_symmetric_cholmod",
                          {.topology = "faces", .parameters = "symmetric", .solver = "supernodal"}),
                    plate("prior", {.more = "prior = { weight = 0.1 }\n"}),
                    plate("prior_tied", {.parameters = "symmetric", .more = "prior = { weight = 10 }\n"}),
                    block("block_prior", {.supports = "minimal", .more = "prior = { weight = 0.1 }\n"})),
    [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace nodal::elastic
