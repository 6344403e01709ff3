// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/trial.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "toy.h"

namespace nodal {
namespace {

// Halves the distance to the optimum of the toy bowl again and again: deterministic and quick.
class Halving final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override {
    std::vector<double> x(start.begin(), start.end());
    (void)random();
    for (int i = 0; i < 40 && !meter.spent(); ++i) {
      for (std::size_t j = 0; j < x.size(); ++j) x[j] += 0.5 * (0.25 * static_cast<double>(j + 1) - x[j]);
      (void)meter.value(x);
    }
    Outcome outcome;
    outcome.reason = "40 halvings";
    outcome.claim = Claim{0.0, x, 40, "done"};
    outcome.effective_options.set("factor", 0.5);
    return outcome;
  }
};

class Throwing final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double>, RandomStream&) override {
    const std::vector<double> x = {0.2, 0.5, 0.7};
    (void)meter.value(x);
    throw std::runtime_error("lost its way");
  }
};

// Its races see costs; refined, every point but the start is refused.
class UnauditedEvaluator final : public Evaluator {
 public:
  Evaluation value(std::span<const double> x) override { return {Status::ok, toy::bowl(x)}; }
  Evaluation audit(std::span<const double> x) override {
    if (x[0] == -1.5) return value(x);
    return {Status::ill_conditioned, 0.0};
  }
};

class UnauditedProblem final : public Problem {
 public:
  [[nodiscard]] const Space& space() const override { return toy_.space(); }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
    return std::make_unique<UnauditedEvaluator>();
  }

 private:
  toy::ToyProblem toy_;
};

Registry toy_registry() {
  Registry registry;
  registry.add(OptimizerDescription{
      .name = "halving", .deterministic = true, .make = [](const Options&) { return std::make_unique<Halving>(); }});
  registry.add(
      OptimizerDescription{.name = "throwing", .make = [](const Options&) { return std::make_unique<Throwing>(); }});
  return registry;
}

Study toy_study() {
  Study study;
  study.name = "toy";
  study.repeats = 15;
  study.budget.evaluations = 100;
  StudyProblem problem;
  problem.label = problem.kind = "toy";
  problem.problem = std::make_shared<toy::ToyProblem>();
  problem.best_known = problem.problem->known_optimum();
  study.problems.push_back(problem);
  study.optimizers.push_back({.label = "halving", .use = "halving", .options = {}, .deterministic = true});
  study.optimizers.push_back({.label = "throwing", .use = "throwing", .options = {}});
  return study;
}

TEST(Trials, OfDeterministicMethodsRunThreeTimes) {
  Study study = toy_study();
  const std::vector<Trial> trials = all_trials(study);
  EXPECT_EQ(trials.size(), 18u);
  study.starts = Starts::sampled;
  EXPECT_EQ(all_trials(study).size(), 30u);
  study.repeats = 2;
  EXPECT_EQ(all_trials(study).size(), 4u);
}

TEST(Trials, HaveDifferentKeys) {
  const Study study = toy_study();
  std::set<std::string> keys;
  for (const Trial& trial : all_trials(study)) keys.insert(trial_key(study, trial));
  EXPECT_EQ(keys.size(), all_trials(study).size());
}

TEST(Trials, AreNamedByWhatDeterminesTheirOutcome) {
  const Study study = toy_study();
  const std::string key = trial_key(study, {});
  const auto changed = [&](auto change) {
    Study other = toy_study();
    change(other);
    return trial_key(other, {}) != key;
  };
  EXPECT_TRUE(changed([](Study& s) { s.seed = 2; }));
  EXPECT_TRUE(changed([](Study& s) { s.budget.evaluations = 101; }));
  EXPECT_TRUE(changed([](Study& s) { s.budget.seconds = 1.0; }));
  EXPECT_TRUE(changed([](Study& s) { s.budget.target_gap = 0.1; }));
  EXPECT_TRUE(changed([](Study& s) { s.optimizers[0].multi_start = true; }));
  EXPECT_FALSE(changed([](Study& s) { s.name = "other"; }));
  EXPECT_FALSE(changed([](Study& s) { s.repeats = 99; }));
  EXPECT_FALSE(changed([](Study& s) { s.optimizers.pop_back(); }));
}

TEST(Trials, StartAtSampledPointsThatAllOptimizersShare) {
  Study study = toy_study();
  study.starts = Starts::sampled;
  const std::span<const double> initial = study.problems[0].problem->space().start();
  EXPECT_TRUE(std::ranges::equal(trial_start(study, {0, 0, 0}), initial));
  EXPECT_FALSE(std::ranges::equal(trial_start(study, {0, 0, 1}), initial));
  EXPECT_EQ(trial_start(study, {0, 0, 1}), trial_start(study, {0, 1, 1}));
  EXPECT_NE(trial_start(study, {0, 0, 1}), trial_start(study, {0, 0, 2}));
  EXPECT_TRUE(study.problems[0].problem->space().contains(trial_start(study, {0, 0, 1})));
}

TEST(Trial, RecordsWhatWasSeen) {
  const TrialRecord record = run_trial(toy_study(), {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::finished);
  EXPECT_EQ(record.reason, "40 halvings");
  EXPECT_EQ(record.counts.evaluations, 40);
  EXPECT_EQ(record.counts.values, 40);
  ASSERT_TRUE(record.best.has_value());
  EXPECT_LT(*record.best->summary.quality, 1e-10);
  EXPECT_EQ(record.best->evaluation, 40);
  EXPECT_EQ(record.best->at_bounds, 0);
  EXPECT_EQ(*record.start.cost, toy::bowl(std::vector<double>{-1.5, -1.5, -1.5}));
  ASSERT_TRUE(record.claimed.has_value());
  EXPECT_EQ(record.claimed->x_equals_best, true);
  EXPECT_EQ(record.options.at("factor").number(), 0.5);
  EXPECT_EQ(record.flops_per_value, 100.0);
  EXPECT_EQ(record.trace.front().evaluation, 0);
  EXPECT_GE(record.seconds.total, record.seconds.evaluation);
  EXPECT_GE(record.seconds.optimizer, 0.0);
}

TEST(Trial, EndsAtItsTarget) {
  Study study = toy_study();
  study.budget.target_gap = 1e-3;
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::target);
  EXPECT_EQ(record.counts.evaluations, 10);  // 2^-10 < 1e-3 < 2^-9
}

TEST(Trial, KeepsWhatWasSeenBeforeAnException) {
  const TrialRecord record = run_trial(toy_study(), {0, 1, 0}, toy_registry());
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason, "lost its way");
  ASSERT_TRUE(record.best.has_value());
  EXPECT_EQ(record.best->evaluation, 1);
}

TEST(Trial, OfAProblemThatThrowsAtItsStartIsARowWithTheReason) {
  Study study = toy_study();
  study.problems[0].problem = std::make_shared<toy::ToyProblem>(
      3, [](std::span<const double>) -> double { throw std::runtime_error("no plate"); });
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason, "no plate");
  EXPECT_FALSE(record.best.has_value());
}

// A race that was won by a value which a refined evaluation refuses has not been won.
TEST(Trial, FailsWhenNothingVouchesForItsBest) {
  Study study = toy_study();
  study.problems[0].problem = std::make_shared<UnauditedProblem>();
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason, "40 halvings; a fresh evaluation of the best point is ill_conditioned");
  EXPECT_FALSE(record.health.cost_error.has_value());
}

TEST(Trial, IsAPureFunctionButForSeconds) {
  TrialRecord a = run_trial(toy_study(), {0, 0, 3}, toy_registry()),
              b = run_trial(toy_study(), {0, 0, 3}, toy_registry());
  a.seconds = b.seconds = {};
  for (TracePoint& p : a.trace) p.seconds = 0.0;
  for (TracePoint& p : b.trace) p.seconds = 0.0;
  EXPECT_EQ(to_json_line(a), to_json_line(b));
}

}  // namespace
}  // namespace nodal
