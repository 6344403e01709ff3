// SPDX-License-Identifier: GPL-3.0-or-later
#include "truncated_cg.h"

#include <gtest/gtest.h>

#include <nodal/study.h>
#include "../../support/components.h"

namespace nodal::gauss_newton {
namespace {

// A small plate at its start: a model that conjugate gradients don't solve in a step or two.
class TruncatedCgOnThePlate : public testing::Test {
 protected:
  TruncatedCgOnThePlate()
      : study_(
            parse_study("[problem]\nkind = \"elastic\"\npoints = { counts = [4, 4] }\n", "plate.toml", components())),
        problem_(*study_.problems[0].problem),
        evaluator_(problem_.make_evaluator()),
        meter_(problem_, *evaluator_, problem_.space().start(), {}),
        residuals_(problem_.residual_count()),
        gradient_(problem_.space().size()) {
    EXPECT_TRUE(meter_.residuals(problem_.space().start(), residuals_).ok());
    EXPECT_EQ(meter_.jacobian_transposed_product(residuals_, gradient_), Status::ok);
  }

  Step solve(double radius, const CgLimits& limits, std::size_t pairs = 5) {
    const Box box = {std::vector<double>(gradient_.size(), -radius), std::vector<double>(gradient_.size(), radius)};
    Step step;
    EXPECT_EQ(TruncatedCg(meter_, pairs).solve(residuals_, gradient_, box, limits, step), Status::ok);
    return step;
  }
  static double squared(const std::vector<double>& v) {
    double sum = 0.0;
    for (const double x : v) sum += x * x;
    return sum;
  }

  Study study_;
  const Problem& problem_;
  std::unique_ptr<Evaluator> evaluator_;
  Meter meter_;
  std::vector<double> residuals_, gradient_;
};

TEST_F(TruncatedCgOnThePlate, SaysWhatTheModelSays) {
  const Step step = solve(0.7, {.max_iterations = 30, .tolerance = 0.0});
  std::vector<double> jp(residuals_.size());
  ASSERT_EQ(meter_.jacobian_product(step.p, jp), Status::ok);
  for (std::size_t a = 0; a < jp.size(); ++a) EXPECT_NEAR(step.residuals[a], residuals_[a] + jp[a], 1e-10);
  EXPECT_LT(squared(step.residuals), squared(residuals_));
}

TEST_F(TruncatedCgOnThePlate, StaysInTheBox) {
  const Step step = solve(0.3, {.max_iterations = 50, .tolerance = 0.0});
  EXPECT_TRUE(step.at_side);
  for (const double p : step.p) EXPECT_LE(std::abs(p), 0.3);
}

TEST_F(TruncatedCgOnThePlate, FindsTheLowestPointOfTheModelGivenTime) {
  const Step step = solve(1e6, {.max_iterations = 2000, .tolerance = 0.0}, 0);
  std::vector<double> slope(gradient_.size());
  ASSERT_EQ(meter_.jacobian_transposed_product(step.residuals, slope), Status::ok);
  EXPECT_LT(squared(slope), 1e-12 * squared(gradient_));
}

TEST_F(TruncatedCgOnThePlate, StopsEarlyWhereLittleIsToGain) {
  EXPECT_LT(solve(1e6, {.max_iterations = 2000, .tolerance = 0.5}).iterations,
            solve(1e6, {.max_iterations = 2000, .tolerance = 0.01}).iterations);
}

TEST_F(TruncatedCgOnThePlate, GoesNowhereWhereTheBoxAllowsNothing) {
  const Step step = solve(0.0, {.max_iterations = 10, .tolerance = 0.1});
  EXPECT_EQ(step.iterations, 0);
  for (const double p : step.p) EXPECT_EQ(p, 0.0);
}

}  // namespace
}  // namespace nodal::gauss_newton
