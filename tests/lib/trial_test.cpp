// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/trial.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <utility>

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

// How a problem misbehaves where a trial is reported, or during the race.
struct Mischief {
  std::function<Evaluation(std::span<const double>)> audit = [](std::span<const double> x) {
    return Evaluation{Status::ok, toy::bowl(x)};
  };
  std::function<double(double)> quality = [](double c) { return std::sqrt(2.0 * c); };
  std::function<double(double)> relative_error = [](double c) { return c; };
  std::function<double(std::span<const double>)> cost = toy::bowl;
};

class MischievousEvaluator final : public Evaluator {
 public:
  explicit MischievousEvaluator(const Mischief& mischief) : mischief_(mischief) {}
  Evaluation value(std::span<const double> x) override { return {Status::ok, mischief_.cost(x)}; }
  Evaluation audit(std::span<const double> x) override { return mischief_.audit(x); }

 private:
  const Mischief& mischief_;
};

class MischievousProblem final : public Problem {
 public:
  explicit MischievousProblem(Mischief mischief) : mischief_(std::move(mischief)) {}
  [[nodiscard]] const Space& space() const override { return toy_.space(); }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] double quality(double cost) const override { return mischief_.quality(cost); }
  [[nodiscard]] std::optional<double> relative_error(double cost) const override {
    return mischief_.relative_error(cost);
  }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
    return std::make_unique<MischievousEvaluator>(mischief_);
  }

 private:
  Mischief mischief_;
  toy::ToyProblem toy_;
};

// Ends at once, by a limit of its own or not.
class Limited final : public Optimizer {
 public:
  explicit Limited(bool limited) : limited_(limited) {}
  Outcome minimize(Meter&, std::span<const double>, RandomStream&) override {
    Outcome outcome;
    outcome.limited = limited_;
    return outcome;
  }

 private:
  bool limited_;
};

// Out of the box, to a better point than the start, and back in.
class Leaving final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double>, RandomStream&) override {
    const std::vector<double> outside = {0.2, 3.5, 0.7}, inside = {0.0, 0.0, 0.0};
    (void)meter.value(outside);
    (void)meter.value(inside);
    Outcome outcome;
    outcome.reason = "left";
    return outcome;
  }
};

Registry toy_registry() {
  Registry registry;
  registry.add(OptimizerDescription{
      .name = "halving", .deterministic = true, .make = [](const Options&) { return std::make_unique<Halving>(); }});
  registry.add(
      OptimizerDescription{.name = "throwing", .make = [](const Options&) { return std::make_unique<Throwing>(); }});
  registry.add(
      OptimizerDescription{.name = "leaving", .make = [](const Options&) { return std::make_unique<Leaving>(); }});
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
  study.optimizers.push_back({.label = "leaving", .use = "leaving", .options = {}});
  return study;
}

TEST(Trials, OfDeterministicMethodsRunThreeTimes) {
  Study study = toy_study();
  const std::vector<Trial> trials = all_trials(study);
  EXPECT_EQ(trials.size(), 33u);
  study.starts = Starts::sampled;
  EXPECT_EQ(all_trials(study).size(), 45u);
  study.repeats = 2;
  EXPECT_EQ(all_trials(study).size(), 6u);
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

// On 1 + ½ Σ (x_i − c_i)² a fresh evaluator finds the gradient that is left over: x_i − c_i, over a cost of 1.
TEST(Trial, IsLookedAtByAnEvaluatorOfItsOwn) {
  Study study = toy_study();
  const auto raised = [](std::span<const double> x) { return 1.0 + toy::bowl(x); };
  study.problems[0].problem = std::make_shared<toy::ToyProblem>(3, raised);
  study.problems[0].best_known.reset();
  study.budget.evaluations = 5;
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  ASSERT_TRUE(record.audit.has_value() && record.best.has_value());
  const double left = (1.5 + 0.75) / 32.0;  // of the farthest coordinate, halved five times
  EXPECT_NEAR(record.audit->stationarity.value_or(0.0), left / raised(record.best->x), 1e-15);
  EXPECT_EQ(record.audit->digits, 16.0);
  EXPECT_EQ(parse_record(to_json_line(record), "line").audit->stationarity, record.audit->stationarity);
}

TEST(Trial, SaysNothingOfTheSlopeAtAPerfectFit) {
  const TrialRecord record = run_trial(toy_study(), {0, 0, 0}, toy_registry());
  ASSERT_TRUE(record.audit.has_value());
  EXPECT_FALSE(record.audit->stationarity.has_value());
}

// Whose evaluator makes costs smaller the longer it runs has fooled its own audit, too.
TEST(Trial, FailsWhereAnotherEvaluatorRefutesTheRace) {
  class Drifting final : public Problem {
   public:
    [[nodiscard]] const Space& space() const override { return toy_.space(); }
    [[nodiscard]] Abilities abilities() const override { return {}; }
    [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
      class Own final : public Evaluator {
       public:
        Evaluation value(std::span<const double> x) override {
          return {Status::ok, (1.0 + toy::bowl(x)) / static_cast<double>(++calls_)};
        }
        Evaluation audit(std::span<const double> x) override {
          return {Status::ok, (1.0 + toy::bowl(x)) / static_cast<double>(std::max(1, calls_))};
        }

       private:
        int calls_ = 0;
      };
      return std::make_unique<Own>();
    }

   private:
    toy::ToyProblem toy_;
  };
  Study study = toy_study();
  study.problems[0].problem = std::make_shared<Drifting>();
  study.problems[0].best_known.reset();
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::failed);
  EXPECT_NE(record.reason.find("an evaluator of its own says"), std::string::npos) << record.reason;
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

TrialRecord run_mischief(Mischief mischief, std::size_t optimizer = 0) {
  Study study = toy_study();
  study.problems[0].problem = std::make_shared<MischievousProblem>(std::move(mischief));
  const TrialRecord record = run_trial(study, {0, optimizer, 0}, toy_registry());
  EXPECT_EQ(to_json_line(parse_record(to_json_line(record), "line")), to_json_line(record));
  return record;
}

void expect_the_race_kept(const TrialRecord& record) {
  EXPECT_EQ(record.counts.evaluations, 40);
  ASSERT_TRUE(record.best.has_value());
  EXPECT_EQ(record.best->evaluation, 40);
  EXPECT_LT(record.best->summary.cost.value_or(1.0), 1e-20);
}

bool at_the_start(std::span<const double> x) { return x[0] == -1.5; }

// A race that was won by a value which a refined evaluation refuses has not been won.
TEST(Trial, FailsWhenNothingVouchesForItsBest) {
  const TrialRecord record = run_mischief({.audit = [](std::span<const double> x) {
    return at_the_start(x) ? Evaluation{Status::ok, toy::bowl(x)} : Evaluation{Status::ill_conditioned, 0.0};
  }});
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason, "40 halvings; a fresh evaluation of the best point is ill_conditioned");
  EXPECT_FALSE(record.health.cost_error.has_value());
  expect_the_race_kept(record);
}

TEST(Trial, KeepsWhatTheRaceSawWhereTheAuditSaysNoNumber) {
  for (const double bad : {std::nan(""), -std::numeric_limits<double>::infinity()}) {
    const TrialRecord record = run_mischief({.audit = [bad](std::span<const double> x) {
      return Evaluation{Status::ok, at_the_start(x) ? toy::bowl(x) : bad};
    }});
    EXPECT_EQ(record.end, End::failed);
    EXPECT_EQ(record.reason, "40 halvings; a fresh evaluation of the best point is invalid_input");
    expect_the_race_kept(record);
    EXPECT_EQ(record.trace.size(), 41u);
  }
}

TEST(Trial, KeepsWhatTheRaceSawWhereTheAuditThrows) {
  const TrialRecord record =
      run_mischief({.audit = [](std::span<const double>) -> Evaluation { throw std::runtime_error("no refinement"); }});
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason,
            "40 halvings; a fresh evaluation of the start threw: no refinement; a fresh evaluation of the best point "
            "threw: no refinement");
  expect_the_race_kept(record);
  EXPECT_EQ(record.start.cost, toy::bowl(std::vector<double>{-1.5, -1.5, -1.5}));
}

TEST(Trial, SaysWhichFigureIsNoNumber) {
  const TrialRecord quality = run_mischief({.quality = [](double) { return std::nan(""); }});
  EXPECT_EQ(quality.end, End::failed);
  EXPECT_EQ(quality.reason, "40 halvings; the quality of the start is nan; the quality of the best point is nan");
  expect_the_race_kept(quality);
  EXPECT_FALSE(quality.best->summary.quality.has_value());
  EXPECT_TRUE(quality.best->summary.relative_error.has_value());
  const TrialRecord error = run_mischief({.relative_error = [](double) { return std::nan(""); }});
  EXPECT_EQ(error.end, End::failed);
  EXPECT_EQ(error.reason,
            "40 halvings; the relative error of the start is nan; the relative error of the best point is nan");
  expect_the_race_kept(error);
  EXPECT_EQ(error.trace.size(), 41u);
}

// Minus infinity is no cost, whatever is lower.
TEST(Trial, WhoseQualityThrowsFailsWithTheReason) {
  const auto boom = [](double) -> double { throw std::runtime_error("no quality"); };
  const TrialRecord always = run_mischief({.quality = boom});
  EXPECT_EQ(always.end, End::failed);
  EXPECT_EQ(always.reason,
            "no quality; the quality of the start threw: no quality; the quality of the best point threw: no quality");
  ASSERT_TRUE(always.start.cost.has_value());  // what can be known is kept
  ASSERT_TRUE(always.best.has_value());
  EXPECT_EQ(always.best->summary.cost, always.start.cost);
  EXPECT_FALSE(always.best->summary.quality.has_value());
  EXPECT_EQ(always.best->evaluation, 0);
  EXPECT_EQ(always.counts.evaluations, 0);

  // Once only, at the start.
  const auto thrown = std::make_shared<bool>(false);
  const TrialRecord once = run_mischief({.quality = [thrown](double c) {
    if (!std::exchange(*thrown, true)) throw std::runtime_error("no quality");
    return c;
  }});
  EXPECT_EQ(once.end, End::failed);
  EXPECT_EQ(once.reason, "no quality");
  EXPECT_TRUE(once.best.has_value());

  // Of better points than the start.
  const double at_start = toy::bowl(toy::ToyProblem().space().start());
  const TrialRecord later = run_mischief({.quality = [at_start](double c) {
    if (c < 0.5 * at_start) throw std::runtime_error("too good");
    return c;
  }});
  EXPECT_EQ(later.end, End::failed);
  EXPECT_EQ(later.reason, "too good; the quality of the best point threw: too good");
  ASSERT_TRUE(later.best.has_value());
  EXPECT_EQ(later.counts.evaluations, 1);
}

TEST(Trial, KeepsTheBeginningOfALongReason) {
  const TrialRecord record = run_mischief(
      {.cost = [](std::span<const double>) -> double { throw std::runtime_error("a" + std::string(3'000'000, 'x')); }});
  EXPECT_EQ(record.reason, "a" + std::string(1999, 'x') + "…");
  const Study study = toy_study();
  EXPECT_EQ(lost_trial(study, {0, 0, 0}, End::crashed, std::string(5000, 'y')).reason, std::string(2000, 'y') + "…");
  // As a store of an older build may hold it.
  TrialRecord old = record;
  old.reason = std::string(3'000'000, 'z');
  EXPECT_EQ(parse_record(to_json_line(old), "line").reason, std::string(2000, 'z') + "…");
}

TEST(Trial, SaysWhenALimitOfTheMethodEndedIt) {
  for (const bool limited : {false, true}) {
    Registry registry = toy_registry();
    registry.add(OptimizerDescription{
        .name = "limited", .make = [limited](const Options&) { return std::make_unique<Limited>(limited); }});
    Study study = toy_study();
    study.optimizers.push_back({.label = "limited", .use = "limited", .options = {}});
    const TrialRecord record = run_trial(study, {0, 3, 0}, registry);
    EXPECT_EQ(record.end, End::finished);
    EXPECT_EQ(record.limited, limited);
    EXPECT_EQ(parse_record(to_json_line(record), "line").limited, limited);
    EXPECT_EQ(to_json_line(record).find("limited\":true") != std::string::npos,
              limited);  // else as older builds write it
  }
}

TEST(Trial, CountsMinusInfinityAsRefused) {
  const auto cost = [](std::span<const double> x) {
    return x[0] > 0.2 ? -std::numeric_limits<double>::infinity() : toy::bowl(x);
  };
  const TrialRecord record = run_mischief({.cost = cost});
  EXPECT_EQ(record.end, End::finished);
  EXPECT_GT(record.health.refused, 30);
  ASSERT_TRUE(record.best.has_value());
  EXPECT_LE(record.best->x[0], 0.2);
}

TEST(Trial, FailsWithoutAnyFiniteCost) {
  Study study = toy_study();
  study.budget.evaluations = 30;  // and so by its budget, not by itself
  study.problems[0].problem = std::make_shared<MischievousProblem>(
      Mischief{.cost = [](std::span<const double>) { return std::numeric_limits<double>::infinity(); }});
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason, "evaluations spent; no point had a finite cost");
  EXPECT_FALSE(record.best.has_value());
  EXPECT_EQ(record.health.refused, 30);
}

// The race's values are a hundredth too low everywhere.
TEST(Trial, FailsWhereItsTraceLiesBelowItsBest) {
  const auto plain = [](std::span<const double> x) { return 1.0 + toy::bowl(x); };
  const auto audit = [plain](std::span<const double> x) { return Evaluation{Status::ok, plain(x)}; };
  const auto off_by = [&](double share) {
    return run_mischief({.audit = audit, .cost = [=](std::span<const double> x) { return plain(x) * (1.0 - share); }});
  };
  const TrialRecord false_one = off_by(0.01);
  EXPECT_EQ(false_one.end, End::failed);
  EXPECT_EQ(false_one.reason, "40 halvings; the race saw a cost of 0.99 at the best point, a fresh evaluation says 1");
  EXPECT_NEAR(*false_one.health.drift, 0.01, 1e-12);
  EXPECT_EQ(off_by(1e-5).end, End::failed);
  EXPECT_EQ(off_by(1e-7).end, End::finished);
  EXPECT_EQ(off_by(-0.01).end, End::finished);  // seen as worse than it is
}

TEST(Trial, FailsWhereABetterPointIsOutsideTheBox) {
  const TrialRecord record = run_mischief({}, 2);
  EXPECT_EQ(record.end, End::failed);
  EXPECT_EQ(record.reason,
            "left; a better point, at evaluation 1, lies outside the box: x1 = 3.5 is not within [-2, 3]");
  ASSERT_TRUE(record.best.has_value());
  EXPECT_EQ(record.best->x, (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(record.best->evaluation, 2);
}

TEST(Trial, FailsWhereTheProblemChangesItsPoints) {
  const auto change = [](std::span<const double> x) { const_cast<double*>(x.data())[0] = 1e6; };
  const TrialRecord racing = run_mischief({.cost = [=](std::span<const double> x) {
    const double cost = toy::bowl(x);
    if (cost < 1.0) change(x);
    return cost;
  }});
  EXPECT_EQ(racing.end, End::failed);
  EXPECT_NE(racing.reason.find("lies outside the box: x0 = 1000000"), std::string::npos) << racing.reason;
  const TrialRecord audited = run_mischief({.audit = [=](std::span<const double> x) {
    const double cost = toy::bowl(x);
    change(x);
    return Evaluation{Status::ok, cost};
  }});
  EXPECT_EQ(audited.end, End::failed);
  EXPECT_NE(audited.reason.find("the problem changes the point that it is given"), std::string::npos) << audited.reason;
  EXPECT_NEAR(audited.best->x[0], 0.25, 1e-9);
}

// The race sees the start a little off; start and best are reported from the same refined evaluation.
TEST(Trial, MeasuresStartAndBestAlike) {
  Study study = toy_study();
  const auto audit = [](std::span<const double> x) { return Evaluation{Status::ok, 1.0 + toy::bowl(x)}; };
  const auto cost = [](std::span<const double> x) {
    return (1.0 + toy::bowl(x)) * (1.0 + 1e-12) + (at_the_start(x) ? 0.0 : 99.0);
  };
  study.problems[0].problem = std::make_shared<MischievousProblem>(Mischief{.audit = audit, .cost = cost});
  const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
  EXPECT_EQ(record.end, End::finished) << record.reason;
  EXPECT_EQ(record.best->evaluation, 0);
  EXPECT_EQ(record.start.cost, record.best->summary.cost);
  EXPECT_EQ(record.start.quality, record.best->summary.quality);
  ASSERT_EQ(record.trace.size(), 1u);
  EXPECT_EQ(record.trace[0].quality, record.best->summary.quality);
}

TEST(Trial, ThatStartsAtTheBestKnownIsAtItsTarget) {
  Study study = toy_study();
  study.budget.target_gap = 1e-3;
  const auto cost = [](std::span<const double> x) { return at_the_start(x) ? 0.5 * 0.73763 * 0.73763 : 9.0; };
  const auto audit = [=](std::span<const double> x) { return Evaluation{Status::ok, cost(x)}; };
  study.problems[0].problem = std::make_shared<MischievousProblem>(Mischief{.audit = audit, .cost = cost});
  const auto end_with = [&](double best_known) {
    study.problems[0].best_known = KnownOptimum{best_known, "by hand", {}};
    const TrialRecord record = run_trial(study, {0, 0, 0}, toy_registry());
    return std::pair(record.end, record.counts.evaluations);
  };
  EXPECT_EQ(end_with(0.7376), std::pair(End::target, std::int64_t{0}));
  EXPECT_EQ(end_with(0.73763), std::pair(End::target, std::int64_t{0}));
  EXPECT_EQ(end_with(0.73762).first, End::finished);
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
