// SPDX-License-Identifier: GPL-3.0-or-later
// Annealing's loop on problems whose every step is known.
#include "annealing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "annealed.h"

namespace nodal::annealing {
namespace {

Annealed anneal(const toy::ToyProblem& problem, const Settings& settings, std::uint64_t key = 1,
                const Limits& limits = {.evaluations = 1000000}) {
  return annealed(problem, Annealing(settings), limits, key);
}

// Where nothing is better, every temperature takes its 2e + 1 steps; an equal value is no worse, so it is accepted.
TEST(Annealing, TakesTwoETimesTwoEPlusOneStepsWhereNothingIsGood) {
  const toy::ToyProblem flat(5, [](std::span<const double>) { return 1.0; });
  const Annealed run = anneal(flat, {});
  EXPECT_EQ(run.counts.proposed, 10 * 11);
  EXPECT_EQ(run.counts.evaluations, 10 * 11);
  EXPECT_EQ(run.counts.accepted, 10 * 11);
  EXPECT_EQ(run.outcome.reason, "10 temperatures done");
}

// Where every step is good, a temperature ends after e + 1 of them.
TEST(Annealing, LeavesATemperatureAfterEPlusOneGoodSteps) {
  double cost = 1.0;
  const toy::ToyProblem falling(5, [&cost](std::span<const double>) { return cost *= 0.99; });
  const Annealed run = anneal(falling, {});
  EXPECT_EQ(run.counts.proposed, 10 * 6);
  EXPECT_EQ(run.counts.accepted, 10 * 6);
}

TEST(Annealing, TellsTheScheduleThatItUsed) {
  const Annealed run = anneal(toy::ToyProblem(5), {});
  const Value& options = run.outcome.effective_options;
  EXPECT_EQ(options.at("temperatures").integer(), 10);
  EXPECT_EQ(options.at("steps").integer(), 10);
  EXPECT_EQ(options.at("good_steps").integer(), 5);
}

TEST(Annealing, HonoursItsOptions) {
  const toy::ToyProblem flat(5, [](std::span<const double>) { return 1.0; });
  const Annealed run = anneal(flat, {.temperatures = 3, .steps = 4, .good_steps = 2});
  EXPECT_EQ(run.counts.proposed, 3 * 5);
}

TEST(Annealing, EndsEarlyWhenConverged) {
  const toy::ToyProblem bowl(5);
  Settings settings{.initial_temperature = 1e-6, .temperatures = 1000};
  settings.convergence = {.enabled = true, .worse_share = 0.01, .improvement = 1e-3};
  const Annealed stopped = anneal(bowl, settings);
  settings.convergence.enabled = false;
  const Annealed whole = anneal(bowl, settings);
  EXPECT_LT(stopped.counts.proposed, whole.counts.proposed / 2);
  EXPECT_TRUE(stopped.outcome.reason.starts_with("converged at temperature ")) << stopped.outcome.reason;
}

TEST(Annealing, FindsTheBottomOfABowl) {
  const toy::ToyProblem bowl(5);
  const Annealed run = anneal(bowl, {.temperatures = 200});
  const auto evaluator = bowl.make_evaluator();
  EXPECT_LT(run.best_quality, 0.05 * bowl.quality(evaluator->value(bowl.space().start()).cost));
}

// A step that can't be evaluated is never taken.
TEST(Annealing, KeepsOutOfWhatCantBeEvaluated) {
  const toy::ToyProblem half(3, [](std::span<const double> x) { return x[0] > -1.4 ? std::nan("") : toy::bowl(x); });
  const Annealed run = anneal(half, {.temperatures = 50});
  EXPECT_TRUE(std::isfinite(run.best_quality));
}

TEST(Annealing, FailsWhereTheStartCantBeEvaluated) {
  const toy::ToyProblem broken(3, [](std::span<const double>) { return std::nan(""); });
  const Annealed run = anneal(broken, {});
  EXPECT_TRUE(run.outcome.failed);
  EXPECT_EQ(run.outcome.reason,
            "the start can't be evaluated: a coordinate or the cost is no finite number (invalid_input)");
}

}  // namespace
}  // namespace nodal::annealing
