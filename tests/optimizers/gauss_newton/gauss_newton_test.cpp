// SPDX-License-Identifier: GPL-3.0-or-later
// Known optima of the 25-node plate and of functions; the contracts are tested over all optimizers elsewhere.
#include <gtest/gtest.h>

#include <string>

#include <nodal/trial.h>

#include "../../support/components.h"

namespace nodal {
namespace {

TrialRecord run(const std::string& problem, const std::string& budget, const std::string& options = "") {
  const std::string text = "[study]\nname = \"s\"\n[budget]\n" + budget + "\n[problem]\n" + problem +
                           "\n[[optimizer]]\nuse = \"gauss-newton\"\noptions = {" + options + "}\n";
  return run_trial(parse_study(text, "s.toml", components()), {}, components());
}

TrialRecord fit(const std::string& poisson, const std::string& budget = "evaluations = 2000") {
  return run("kind = \"elastic\"\nmaterial = { poisson = " + poisson + " }", budget);
}

double best_quality(const TrialRecord& record) {
  return record.best && record.best->summary.quality ? *record.best->summary.quality : -1.0;
}

TEST(GaussNewtonOnThePlate, ReachesTheBestKnownFit) {
  const TrialRecord record = fit("0.3");
  EXPECT_NEAR(best_quality(record), 0.7376255865, 1e-7);
  EXPECT_EQ(record.counts.jacobians, 0);
  EXPECT_GT(record.counts.products, 0);
}

TEST(GaussNewtonOnThePlate, FitsExactlyWhereSpringsCan) { EXPECT_LT(best_quality(fit("0.33333333333333331")), 1e-6); }

TEST(GaussNewtonOnThePlate, GetsPastBoundsThatAMinimumTouches) {
  // Some springs end at their lower bound. Any of the known minima will do: 2.32, 2.43, 2.44, 2.47, 2.58.
  const double quality = best_quality(fit("0.2"));
  EXPECT_GT(quality, 2.3208);
  EXPECT_LT(quality, 2.6);
}

TEST(GaussNewtonOnThePlate, KeepsTheBudget) {
  const TrialRecord record = fit("0.3", "evaluations = 7");
  EXPECT_EQ(record.counts.evaluations, 7);
  EXPECT_EQ(record.end, End::budget);
}

TEST(GaussNewtonOnThePlate, DoesTheSameEveryTime) {
  const TrialRecord a = fit("0.2"), b = fit("0.2");
  EXPECT_EQ(a.best->x, b.best->x);
  EXPECT_EQ(a.counts.products, b.counts.products);
}

// Many springs, each changed a little, change the long waves by a term of second order: without its correction, long
// conjugate gradients are wasted on steps that have to be taken shorter.
TEST(GaussNewtonOnThePlate, KeepsLongStepsByCorrectingThem) {
  const std::string plate = "kind = \"elastic\"\npoints = { counts = [30, 30] }";
  const TrialRecord with = run(plate, "evaluations = 40");
  const TrialRecord without = run(plate, "evaluations = 40", "correction_iterations = 0");
  EXPECT_LT(best_quality(with), 0.97 * best_quality(without));
}

TEST(GaussNewton, SolvesRosenbrocksFunction) {
  for (const char* dimension : {"2", "20"}) {
    const TrialRecord record =
        run("kind = \"rosenbrock\"\ndimension = " + std::string(dimension), "evaluations = 5000");
    EXPECT_LT(record.best->summary.cost, 1e-20) << dimension;
  }
}

TEST(GaussNewton, SaysWhenItsOwnLimitEndedIt) {
  const char* problem = "kind = \"rosenbrock\"\ndimension = 2";
  EXPECT_TRUE(run(problem, "evaluations = 5000", "max_iterations = 2").limited);
  EXPECT_FALSE(run(problem, "evaluations = 5000").limited);
}

TEST(GaussNewton, BeginsAtTheStartItselfWithoutJitter) {
  const TrialRecord with = run("kind = \"rosenbrock\"\ndimension = 2", "evaluations = 1");
  const TrialRecord without = run("kind = \"rosenbrock\"\ndimension = 2", "evaluations = 1", "jitter = 0.0");
  // The start was evaluated before the race and isn't counted again: the one evaluation is a step, or the moved start.
  EXPECT_EQ(with.counts.evaluations, 1);
  EXPECT_EQ(without.counts.evaluations, 1);
  EXPECT_EQ(with.counts.residuals, 1);
  EXPECT_EQ(without.counts.residuals, 2);
}

}  // namespace
}  // namespace nodal
