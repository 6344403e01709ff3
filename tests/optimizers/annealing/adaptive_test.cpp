// SPDX-License-Identifier: GPL-3.0-or-later
// The annealing that adapts: its schedule on problems whose every step is known, and its steps.
#include "adaptive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "annealed.h"

namespace nodal::annealing {
namespace {

Annealed anneal_adaptively(const toy::ToyProblem& problem, const AdaptiveSettings& settings,
                           std::int64_t evaluations = 1000000) {
  return annealed(problem, AdaptiveAnnealing(settings), {.evaluations = evaluations}, 1);
}

// No progress: trial proposals, then `patience` temperatures before each reheat and before the end.
TEST(AdaptiveAnnealing, EndsAfterItsReheatsWhereNothingGetsBetter) {
  const toy::ToyProblem flat(5, [](std::span<const double>) { return 1.0; });
  const Annealed run = anneal_adaptively(flat, {.sweeps = 3.0, .patience = 4, .reheats = 2});
  EXPECT_EQ(run.outcome.reason, "no progress after 2 reheats");
  EXPECT_EQ(run.counts.proposed, 5 + 3 * 4 * (3 * 5));
}

// The bowl's worsening by steps of at most 0.2 is known to the option: a share χ of it is accepted at T₀.
TEST(AdaptiveAnnealing, TakesItsTemperatureFromTheFirstWorsening) {
  const toy::ToyProblem bowl(5);
  const double low = anneal_adaptively(bowl, {.initial_acceptance = 0.1}, 50)
                         .outcome.effective_options.at("initial_temperature")
                         .number();
  const double high = anneal_adaptively(bowl, {.initial_acceptance = 0.5}, 50)
                          .outcome.effective_options.at("initial_temperature")
                          .number();
  EXPECT_GT(low, 0.0);
  EXPECT_NEAR(high / low, std::log(10.0) / std::log(2.0), 1e-12);
}

TEST(AdaptiveAnnealing, AcceptsTheShareThatIsAskedFor) {
  const toy::ToyProblem bowl(5);
  for (const double share : {0.2, 0.44, 0.7}) {
    const Annealed run = anneal_adaptively(bowl, {.acceptance = share, .reduction = 1.0, .patience = 1000000}, 50000);
    // At a constant temperature; the way down from the start and the noise of 50,000 draws leave this much.
    EXPECT_NEAR(static_cast<double>(run.counts.accepted) / static_cast<double>(run.counts.proposed), share, 0.02);
  }
}

TEST(AdaptiveAnnealing, FindsTheBottomOfABowl) {
  const toy::ToyProblem bowl(5);
  const auto evaluator = bowl.make_evaluator();
  EXPECT_LT(anneal_adaptively(bowl, {}).best_quality, 1e-2 * bowl.quality(evaluator->value(bowl.space().start()).cost));
}

TEST(AdaptiveAnnealing, FailsWhereTheStartCantBeEvaluated) {
  const toy::ToyProblem broken(3, [](std::span<const double>) { return std::nan(""); });
  EXPECT_TRUE(anneal_adaptively(broken, {}).outcome.failed);
}

}  // namespace
}  // namespace nodal::annealing
