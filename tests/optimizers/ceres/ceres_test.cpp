// SPDX-License-Identifier: GPL-3.0-or-later
// Every method of Ceres on small problems with known optima, and on problems that misbehave.
#include <gtest/gtest.h>

#include "../toy_problems.h"

namespace nodal {

void register_ceres(Registry& registry);

namespace {

using toy::Report;

const Registry& ceres_registry() {
  static const Registry registry = [] {
    Registry r;
    register_ceres(r);
    return r;
  }();
  return registry;
}

const OptimizerDescription& description(const std::string& name) {
  const OptimizerDescription* found = ceres_registry().find_optimizer(name);
  if (!found) throw std::logic_error(name);
  return *found;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const OptimizerDescription& d : ceres_registry().optimizers()) result.push_back(d.name);
  return result;
}

Limits evaluations(std::int64_t n) { return {.evaluations = n}; }

// A hang would show as a test that never ends; a run that merely ends late shows here. Far above the deadlines set.
constexpr double kPatienceSeconds = 20.0;

class CeresMethods : public testing::TestWithParam<std::string> {
 protected:
  const OptimizerDescription& method() const { return description(GetParam()); }
  // Nothing may be written to stderr, whatever happens.
  void SetUp() override { testing::internal::CaptureStderr(); }
  void TearDown() override { EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); }
};

INSTANTIATE_TEST_SUITE_P(All, CeresMethods, testing::ValuesIn(names()),
                         [](const auto& parameter) { return toy::test_name(parameter.param); });

TEST_P(CeresMethods, ReachTheOptimumOfABowl) {
  const Report report = run(method(), toy::bowl(), evaluations(1000));
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  EXPECT_LT(report.best_cost, 1e-12) << report.outcome.reason;
}

TEST_P(CeresMethods, DescendTheValleyOfRosenbrock) {
  const Report report = run(method(), toy::rosenbrock(), evaluations(10000));
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  EXPECT_LT(report.best_cost, 1e-12) << report.outcome.reason;
}

TEST_P(CeresMethods, FindAMinimumOnTheBorder) {
  const Report report = run(method(), toy::bowl_beyond_the_box(), evaluations(1000));
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  // ½(2² + 1²) at the corner (3, 3); the toy throws when a point outside is evaluated.
  EXPECT_NEAR(report.best_cost, 2.5, 1e-9) << report.outcome.reason;
}

TEST_P(CeresMethods, KeepABudgetOf37) {
  Value given;  // tolerances off, so that nothing but the budget and rounding ends it
  for (const char* key : {"function_tolerance", "gradient_tolerance", "parameter_tolerance"}) given.set(key, 0.0);
  const Report report = run(method(), toy::rosenbrock(), evaluations(37), 1, given);
  EXPECT_LE(report.counts.evaluations, 37);
  EXPECT_TRUE(report.stop == Stop::evaluations || report.best_cost < 1e-12) << report.outcome.reason;
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
}

TEST_P(CeresMethods, SayWhenTheirOwnLimitEndedThem) {
  Value given;
  given.set("max_iterations", 1);
  const Report ended = run(method(), toy::rosenbrock(), evaluations(10000), 1, given);
  EXPECT_TRUE(ended.outcome.limited) << ended.outcome.reason;
  EXPECT_FALSE(run(method(), toy::bowl(), evaluations(1000)).outcome.limited);
}

TEST_P(CeresMethods, KeepABudgetOfThree) {
  const Report report = run(method(), toy::rosenbrock(), evaluations(3));
  EXPECT_EQ(report.counts.evaluations, 3);
  EXPECT_EQ(report.stop, Stop::evaluations);
  EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
}

TEST_P(CeresMethods, EndAtADeadline) {
  const Report report = run(method(), toy::with_hook(toy::sleeps(std::chrono::milliseconds(20))), {.seconds = 0.2});
  EXPECT_LT(report.seconds, kPatienceSeconds);
  EXPECT_LE(report.counts.evaluations, 11);
}

TEST_P(CeresMethods, LetAnExceptionOutUnchanged) {
  for (const int n : {2, 3, 7}) {
    try {
      (void)run(method(), toy::with_hook(toy::throws_at(n)), evaluations(1000));
      ADD_FAILURE() << "nothing came out at " << n;
    } catch (const toy::Mishap& mishap) {
      EXPECT_EQ(mishap.code, 42);
    }
  }
}

TEST_P(CeresMethods, SurviveNonFiniteCostsInHalfTheBox) {
  for (const double factor : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Report report =
        run(method(), toy::with_hook(toy::spoiled_half(factor)), {.seconds = 2.0, .evaluations = 2000});
    EXPECT_TRUE(std::isfinite(report.best_cost));
    EXPECT_LT(report.best_cost, report.start_cost);
    EXPECT_LE(report.best[0], 0.0);
    EXPECT_FALSE(report.outcome.failed) << report.outcome.reason;
  }
}

TEST_P(CeresMethods, FailWithAReasonWhereNothingCanBeEvaluated) {
  const auto nan_everywhere = [](std::span<const double>) { return std::numeric_limits<double>::quiet_NaN(); };
  const Report report = run(method(), toy::with_hook(nan_everywhere), evaluations(100));
  EXPECT_TRUE(report.outcome.failed);
  EXPECT_NE(report.outcome.reason.find("no step lowered the cost"), std::string::npos) << report.outcome.reason;
}

TEST_P(CeresMethods, SayThatAFlatCostWasNotLowered) {
  const Report report = run(method(), toy::flat(), {.seconds = 0.5, .evaluations = 1000});
  EXPECT_EQ(report.best_cost, report.start_cost);
  EXPECT_NE(report.outcome.reason.find("no step lowered the cost"), std::string::npos) << report.outcome.reason;
}

TEST_P(CeresMethods, RepeatTheirTrace) {
  const std::unique_ptr<Optimizer> optimizer = method().make(toy::options_for(method()));
  const Report first = run(*optimizer, toy::rosenbrock(), evaluations(500), 7);
  const Report second = run(*optimizer, toy::rosenbrock(), evaluations(500), 7);  // of the same object
  const Report other = run(method(), toy::rosenbrock(), evaluations(500), 8);
  EXPECT_TRUE(same_trace(first, second));
  EXPECT_TRUE(same_trace(first, other));  // deterministic
}

TEST_P(CeresMethods, ClaimWhatTheMeterSaw) {
  const Report report = run(method(), toy::rosenbrock(), evaluations(5000));
  ASSERT_TRUE(report.outcome.claim);
  const Claim& claim = *report.outcome.claim;
  EXPECT_FALSE(claim.status.empty());
  if (claim.status == "FAILURE") {  // a line search that ends at rounding: Ceres then says nothing of what it reached
    EXPECT_FALSE(claim.cost);
    EXPECT_TRUE(claim.x.empty());
    return;
  }
  ASSERT_TRUE(claim.cost);
  EXPECT_GE(*claim.cost, report.best_cost);
  EXPECT_EQ(claim.x.size(), 2u);
}

TEST(CeresOptions, AreReadBackFromTheLibrary) {
  const auto effective = [](const char* name, const Value& given = {}) {
    return run(description(name), toy::rosenbrock(), evaluations(100), 1, given).outcome.effective_options;
  };
  const Value marquardt = effective("ceres-levenberg-marquardt");
  EXPECT_EQ(marquardt.at("minimizer").text(), "trust-region");
  EXPECT_EQ(marquardt.at("strategy").text(), "levenberg-marquardt");
  EXPECT_EQ(marquardt.at("linear_solver").text(), "dense-normal-cholesky");
  EXPECT_EQ(marquardt.at("threads").integer(), 1);
  Value given;
  given.set("linear_solver", "dense-qr");
  given.set("dogleg", "subspace-dogleg");
  const Value dogleg = effective("ceres-dogleg", given);
  EXPECT_EQ(dogleg.at("strategy").text(), "dogleg");
  EXPECT_EQ(dogleg.at("dogleg").text(), "subspace-dogleg");
  EXPECT_EQ(dogleg.at("linear_solver").text(), "dense-qr");
  EXPECT_EQ(effective("ceres-lbfgs").at("direction").text(), "lbfgs");
  EXPECT_EQ(effective("ceres-bfgs").at("direction").text(), "bfgs");
  for (const char* type : {"fletcher-reeves", "polak-ribiere", "hestenes-stiefel"}) {
    Value conjugate;
    conjugate.set("type", type);
    const Value ncg = effective("ceres-ncg", conjugate);
    EXPECT_EQ(ncg.at("direction").text(), "nonlinear-conjugate-gradient");
    EXPECT_EQ(ncg.at("type").text(), type);
  }
}

TEST(CeresOptions, AnUnknownSolverIsRefused) {
  Value given;
  given.set("linear_solver", "sparse-qr");
  EXPECT_THROW((void)toy::options_for(description("ceres-dogleg"), given), InputError);
}

TEST(CeresCounting, AJacobianAfterResidualsAtOnePointIsOneEvaluation) {
  const Report report = run(description("ceres-levenberg-marquardt"), toy::bowl(), evaluations(1000));
  EXPECT_GT(report.counts.jacobians, 0);
  EXPECT_LT(report.counts.evaluations, report.counts.residuals);
}

}  // namespace
}  // namespace nodal
