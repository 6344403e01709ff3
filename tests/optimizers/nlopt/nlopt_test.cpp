// SPDX-License-Identifier: GPL-3.0-or-later
// Every method of NLopt on small problems with known optima, and on problems that misbehave.
#include <gtest/gtest.h>

#include <algorithm>

#include "../toy_problems.h"

namespace nodal {

void register_nlopt(Registry& registry);

namespace {

using toy::Report;

const Registry& nlopt_registry() {
  static const Registry registry = [] {
    Registry r;
    register_nlopt(r);
    return r;
  }();
  return registry;
}

const OptimizerDescription& description(const std::string& name) {
  const OptimizerDescription* found = nlopt_registry().find_optimizer(name);
  if (!found) throw std::logic_error(name);
  return *found;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const OptimizerDescription& d : nlopt_registry().optimizers()) result.push_back(d.name);
  return result;
}

Limits evaluations(std::int64_t n) { return {.evaluations = n}; }

// A hang would show as a test that never ends; a run that merely ends late shows here. Far above the deadlines set.
constexpr double kPatienceSeconds = 20.0;

class NloptMethods : public testing::TestWithParam<std::string> {
 protected:
  const OptimizerDescription& method() const { return description(GetParam()); }
  // To be there, whatever the method. MLSL looks at all pairs of its samples: 20,000 take it seconds.
  Limits plenty() const { return evaluations(GetParam().starts_with("nlopt-mlsl") ? 4000 : 20000); }
};

INSTANTIATE_TEST_SUITE_P(All, NloptMethods, testing::ValuesIn(names()),
                         [](const auto& parameter) { return toy::test_name(parameter.param); });

TEST_P(NloptMethods, ReachTheOptimumOfABowl) {
  const Report report = run(method(), toy::bowl(), plenty());
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  // Local methods converge. Global ones only come near: a cost of 1e-3 is a distance of 0.04 in a box of width 5.
  EXPECT_LT(report.best_cost, method().local ? 1e-12 : 1e-3) << report.outcome.reason;
}

TEST_P(NloptMethods, DescendTheValleyOfRosenbrock) {
  const Report report = run(method(), toy::rosenbrock(), plenty());
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  // Local methods converge (Nelder-Mead's simplex within rounding of values); global ones get into the valley.
  EXPECT_LT(report.best_cost, method().local ? 1e-10 : 0.1) << report.outcome.reason;
}

TEST_P(NloptMethods, FindAMinimumOnTheBorder) {
  const Report report = run(method(), toy::bowl_beyond_the_box(), plenty());
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  // ½(2² + 1²) at the corner (3, 3). DIRECT sees centres of boxes only, the evolution strategies draw.
  EXPECT_NEAR(report.best_cost, 2.5, method().local ? 1e-9 : 0.05);
}

TEST_P(NloptMethods, KeepABudgetOf37) {
  const Report report = run(method(), toy::rosenbrock(), evaluations(37));
  // A local method may be done before.
  EXPECT_LE(report.counts.evaluations, 37);
  EXPECT_TRUE(report.stop == Stop::evaluations || (method().local && report.best_cost < 1e-12))
      << report.outcome.reason;
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  EXPECT_LE(report.best_cost, report.start_cost);
}

TEST_P(NloptMethods, EndAtADeadline) {
  const Report report = run(method(), toy::with_hook(toy::sleeps(std::chrono::milliseconds(5))), {.seconds = 0.2});
  EXPECT_LT(report.seconds, kPatienceSeconds);
  EXPECT_LE(report.counts.evaluations, 41);
}

TEST_P(NloptMethods, LetAnExceptionOutUnchanged) {
  for (const int n : {2, 3, 7}) {
    try {
      (void)run(method(), toy::with_hook(toy::throws_at(n)), evaluations(1000));
      ADD_FAILURE() << "nothing came out at " << n;
    } catch (const toy::Mishap& mishap) {
      EXPECT_EQ(mishap.code, 42);
    }
  }
}

TEST_P(NloptMethods, SurviveNonFiniteCostsInHalfTheBox) {
  for (const double factor : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Report report = run(method(), toy::with_hook(toy::spoiled_half(factor)), evaluations(2000));
    EXPECT_TRUE(std::isfinite(report.best_cost));
    EXPECT_LE(report.best_cost, report.start_cost);
    EXPECT_LE(report.best[0], 0.0);
  }
}

TEST_P(NloptMethods, EndOnAFlatCost) {
  const Report report = run(method(), toy::flat(), {.seconds = 0.5, .evaluations = 5000});
  EXPECT_LT(report.seconds, kPatienceSeconds);
  EXPECT_EQ(report.best_cost, report.start_cost);
}

TEST_P(NloptMethods, HaveFinishedWhereTheStartIsTheOptimum) {
  for (const double off : {0.0, 1e-13, 1e-9}) {
    const Report report = run(method(), toy::Shape{.centre = {toy::kStart + off, toy::kStart}}, evaluations(500));
    EXPECT_FALSE(report.outcome.failed) << off << ": " << report.outcome.reason;
    EXPECT_FALSE(report.outcome.reason.empty());
    EXPECT_LE(report.best_cost, report.start_cost);
  }
}

// The slope is steep there, but leads out of the box.
TEST_P(NloptMethods, HaveFinishedWhereTheStartIsTheBestCorner) {
  toy::Shape shape = toy::bowl_beyond_the_box();
  shape.start = 3.0;
  const Report report = run(method(), shape, evaluations(500));
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  EXPECT_NEAR(report.best_cost, 2.5, 1e-12);
}

// A slope that leads nowhere: ten times the cost wherever one goes. Line searches find no way on, and that is a
// failure.
TEST(NloptLineSearches, FailWhereASlopeLeadsNowhere) {
  const auto only_the_start = [](std::span<const double> x) {
    return x[0] == toy::kStart && x[1] == toy::kStart ? 1.0 : 10.0;
  };
  for (const char* name : {"nlopt-lbfgs", "nlopt-var2"}) {
    const Report report = run(description(name), toy::with_hook(only_the_start), evaluations(2000));
    EXPECT_TRUE(report.outcome.failed) << name << ": " << report.outcome.reason;
  }
}

TEST_P(NloptMethods, RepeatTheirTraceForTheSameSeed) {
  const std::unique_ptr<Optimizer> optimizer = method().make(toy::options_for(method()));
  const Report first = run(*optimizer, toy::rosenbrock(), evaluations(500), 7);
  const Report second = run(*optimizer, toy::rosenbrock(), evaluations(500), 7);  // of the same object
  const Report fresh = run(method(), toy::rosenbrock(), evaluations(500), 7);
  const Report other = run(method(), toy::rosenbrock(), evaluations(500), 8);
  EXPECT_TRUE(same_trace(first, second));
  EXPECT_TRUE(same_trace(first, fresh));
  EXPECT_EQ(same_trace(first, other), method().deterministic);
}

TEST_P(NloptMethods, ClaimWhatTheMeterSaw) {
  const Report report = run(method(), toy::rosenbrock(), evaluations(5000));
  ASSERT_TRUE(report.outcome.claim);
  const Claim& claim = *report.outcome.claim;
  EXPECT_FALSE(claim.status.empty());
  ASSERT_TRUE(claim.cost && claim.evaluations);
  EXPECT_GE(*claim.cost, report.best_cost);
  EXPECT_GE(*claim.evaluations, report.counts.evaluations);
  EXPECT_EQ(claim.x.size(), 2u);
}

TEST_P(NloptMethods, UseTheStartAsTheySay) {
  int at_start = 0;
  const toy::LeastSquares problem(toy::with_hook([&at_start](std::span<const double> x) {
    at_start += x[0] == toy::kStart && x[1] == toy::kStart;
    return 1.0;
  }));
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), evaluations(100));
  // Elsewhere, or a gradient at the start would need no evaluation after the meter's own.
  (void)meter.value(std::vector<double>{0.1, 0.2});
  RandomStream random(1);
  (void)method().make(toy::options_for(method()))->minimize(meter, problem.space().start(), random);
  EXPECT_EQ(at_start > 1, method().uses_start);
}

TEST(NloptOptions, TellWhatWasUsed) {
  const auto effective = [](const char* name) {
    return run(description(name), toy::bowl(), evaluations(100)).outcome.effective_options;
  };
  EXPECT_EQ(effective("nlopt-crs2-lm").at("population").integer(), 30);  // 10 (n + 1)
  EXPECT_EQ(effective("nlopt-isres").at("population").integer(), 60);    // 20 (n + 1)
  EXPECT_EQ(effective("nlopt-esch").at("population").integer(), 40);
  EXPECT_EQ(effective("nlopt-lbfgs").at("vector_storage").integer(), 10);
  EXPECT_EQ(effective("nlopt-mlsl-lds").at("local").text(), "lbfgs");
  // A quarter of the box, but here three quarters of the way to the nearer bound; up to rounding.
  EXPECT_NEAR(effective("nlopt-sbplx").at("initial_step_largest").number(), 0.45, 1e-15);
}

TEST(NloptOptions, GivenPopulationsAreTheLibrarysOwnDefaults) {
  for (const char* name : {"nlopt-crs2-lm", "nlopt-isres", "nlopt-esch"}) {
    Value given;
    given.set("population", name == std::string("nlopt-crs2-lm") ? 30 : name == std::string("nlopt-isres") ? 60 : 40);
    const Report by_default = run(description(name), toy::rosenbrock(), evaluations(500));
    const Report by_hand = run(description(name), toy::rosenbrock(), evaluations(500), 1, given);
    EXPECT_TRUE(same_trace(by_default, by_hand)) << name;
  }
}

TEST(NloptOptions, EveryLocalMethodPolishesSamples) {
  for (const char* name : {"nlopt-mlsl-lds", "nlopt-mlsl-lds-values"}) {
    const OptimizerDescription& mlsl = description(name);
    const auto local = std::ranges::find(mlsl.options, "local", &Option::name);
    ASSERT_NE(local, mlsl.options.end());
    for (const std::string& choice : local->choices) {
      Value given;
      given.set("local", choice);
      const Report report = run(mlsl, toy::bowl(), {.seconds = 5.0, .evaluations = 3000}, 1, given);
      EXPECT_LT(report.best_cost, 1e-6) << name << " with " << choice << ": " << report.outcome.reason;
    }
  }
}

TEST(NloptOptions, AnUnknownLocalMethodIsRefused) {
  Value given;
  given.set("local", "lbfsg");
  EXPECT_THROW((void)toy::options_for(description("nlopt-mlsl-lds"), given), InputError);
  given.set("local", "sbplx");  // needs no gradient: belongs to the other one
  EXPECT_THROW((void)toy::options_for(description("nlopt-mlsl-lds"), given), InputError);
}

TEST(NloptOptions, APopulationTooSmallForTheMethodIsAFailureWithItsReason) {
  Value given;
  given.set("population", 1);
  const Report report = run(description("nlopt-crs2-lm"), toy::bowl(), evaluations(100), 1, given);
  EXPECT_TRUE(report.outcome.failed);
  EXPECT_NE(report.outcome.reason.find("refuses"), std::string::npos) << report.outcome.reason;
}

TEST(NloptMethodsLeftOut, SayWhy) {
  for (const char* name : {"nlopt-cobyla", "nlopt-stogo", "nlopt-ags"}) {
    EXPECT_EQ(nlopt_registry().find_optimizer(name), nullptr);
    ASSERT_NE(nlopt_registry().find_absent(name), nullptr) << name;
    EXPECT_NE(nlopt_registry().find_absent(name)->reason.find("left out"), std::string::npos);
  }
}

}  // namespace
}  // namespace nodal
