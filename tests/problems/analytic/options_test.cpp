// SPDX-License-Identifier: GPL-3.0-or-later
// What can be set on a test function, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "analytic.h"

namespace nodal::analytic {
namespace {

std::string refusal(const std::string& kind, const std::string& settings) {
  try {
    (void)read_problem(kind, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::vector<double> start_of(const StudyProblem& problem) {
  const std::span<const double> start = problem.problem->space().start();
  return {start.begin(), start.end()};
}

TEST(AnalyticOptions, RefuseADimensionTheFunctionIsNotDefinedFor) {
  EXPECT_EQ(refusal("powell-singular", "dimension = 6"),
            "f.toml:3: 'dimension' is 6; powell-singular needs a multiple of 4");
  EXPECT_EQ(refusal("rosenbrock", "dimension = 1"),
            "f.toml:3: 'dimension' of problem 'rosenbrock' is 1; allowed: 2 ≤ dimension ≤ 10000");
  EXPECT_EQ(refusal("sphere", "dimension = 0"),
            "f.toml:3: 'dimension' of problem 'sphere' is 0; allowed: 1 ≤ dimension ≤ 10000");
}

TEST(AnalyticOptions, RefuseBoundsThatAreNoBox) {
  EXPECT_EQ(refusal("sphere", "bounds = [5, 1]"),
            "f.toml:3: 'bounds' is [5, 1]; it must be [lower, upper] with lower < upper");
  EXPECT_EQ(refusal("ackley", "bounds = [1, 1]"),
            "f.toml:3: 'bounds' is [1, 1]; it must be [lower, upper] with lower < upper");
  EXPECT_EQ(refusal("levy", "bounds = [1, 2, 3]"),
            "f.toml:3: 'bounds' of problem 'levy' has 3 entries; it must have 2");
  EXPECT_NE(refusal("levy", "bounds = [-1e308, 1e308]"), "accepted");
}

TEST(AnalyticOptions, RefuseAStartThatIsNoPointOfTheBox) {
  EXPECT_EQ(refusal("rosenbrock", "dimension = 2\nstart = [1.0, 2.0, 3.0]"),
            "f.toml:4: 'start' has 3 entries; with dimension 2 it must have as many");
  EXPECT_EQ(refusal("rosenbrock", "dimension = 2\nstart = [1.0, 11.0]"),
            "f.toml:4: 'start' is 11 in x2, outside the bounds [-5, 10]");
}

TEST(AnalyticOptions, TakeTheCustomaryStart) {
  EXPECT_EQ(start_of(read_problem("rosenbrock", "dimension = 3")), (std::vector<double>{-1.2, 1.0, -1.2}));
  EXPECT_EQ(start_of(read_problem("powell-singular")), (std::vector<double>{3.0, -1.0, 0.0, 1.0}));
  EXPECT_EQ(start_of(read_problem("brown-almost-linear", "dimension = 2")), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(start_of(read_problem("levy", "dimension = 2\nstart = [1, 2]")), (std::vector<double>{1.0, 2.0}));
}

TEST(AnalyticOptions, OtherwiseStartWithoutSymmetryAndAwayFromTheOptimum) {
  for (const char* kind : {"sphere", "rastrigin", "ackley", "griewank", "levy"}) {
    const StudyProblem problem = read_problem(kind, "dimension = 50");
    const double width = problem.problem->space().upper()[0] - problem.problem->space().lower()[0];
    std::vector<double> start = start_of(problem);
    double distance = 0.0;
    for (const double x : start) distance = std::max(distance, std::abs(x - problem.best_known->x[0]));
    EXPECT_GT(distance, 0.2 * width) << kind;
    std::ranges::sort(start);
    // i φ mod 1 for i ≤ 50 keeps a distance of 1/(√5 · 50) = 0.009.
    for (std::size_t i = 1; i < start.size(); ++i) EXPECT_GT(start[i] - start[i - 1], 0.005 * width) << kind;
  }
}

TEST(AnalyticOptions, ClaimNoOptimumThatTheBoundsLeaveOutside) {
  const StudyProblem inside = read_problem("levy", "bounds = [1, 3]");
  EXPECT_TRUE(inside.best_known.has_value());  // bounds belong to the box
  const StudyProblem outside = read_problem("levy", "bounds = [2, 3]");
  EXPECT_FALSE(outside.best_known.has_value());
  EXPECT_EQ(outside.problem->remarks(),
            (std::vector<std::string>{
                "the bounds leave the function's optimum (1 in every coordinate) outside: none is claimed"}));
}

TEST(AnalyticOptions, MoveACustomaryStartIntoTheBox) {
  const StudyProblem problem = read_problem("rosenbrock", "dimension = 3\nbounds = [0, 2]");
  const std::vector<double> start = start_of(problem);
  EXPECT_DOUBLE_EQ(start[0], 2e-6);
  EXPECT_EQ(start[1], 1.0);
  EXPECT_EQ(problem.problem->remarks(),
            (std::vector<std::string>{"the start of 2 of 3 coordinates was outside the bounds and moved just inside"}));
}

TEST(AnalyticOptions, GiveSumsOfSquaresResidualsAndTheOthersNone) {
  const auto rosenbrock = make_function("rosenbrock", 5), griewank = make_function("griewank", 5);
  EXPECT_EQ(rosenbrock->abilities().names(), (std::vector<std::string>{"gradient", "residuals", "jacobian-products"}));
  EXPECT_EQ(rosenbrock->residual_count(), 8u);
  EXPECT_EQ(griewank->abilities().names(), (std::vector<std::string>{"gradient"}));
  EXPECT_EQ(griewank->residual_count(), 0u);
}

}  // namespace
}  // namespace nodal::analytic
