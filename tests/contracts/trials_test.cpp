// SPDX-License-Identifier: GPL-3.0-or-later
// Every optimizer on every problem that can give what it needs, by the way a study runs it.
#include <gtest/gtest.h>

#include <nodal/trial.h>

#include "contender.h"

namespace nodal::contracts {
namespace {

class EveryTrial : public testing::TestWithParam<Contender> {
 protected:
  static Study study() {
    Study study;
    study.name = "contracts";
    study.budget.evaluations = 300;
    const Contender& c = GetParam();
    study.optimizers.push_back({.label = c.name,
                                .use = c.use,
                                .options = c.options(),
                                .multi_start = c.multi_start,
                                .deterministic = c.description().deterministic && !c.multi_start});
    return study;
  }
  static Study study_of(std::shared_ptr<const Problem> problem) {
    Study result = study();
    result.problems.push_back(
        {.label = "toy", .kind = "toy", .options = {}, .problem = std::move(problem), .best_known = {}});
    return result;
  }
};

TEST_P(EveryTrial, HasAnEndAndItsEffectiveOptions) {
  const TrialRecord record = run_trial(study_of(std::make_shared<WatchedProblem>()), {}, components());
  EXPECT_TRUE(record.end == End::budget || record.end == End::finished)
      << to_string(record.end) << ": " << record.reason;
  EXPECT_FALSE(record.reason.empty());
  for (const Option& option : GetParam().description().options)
    EXPECT_NE(record.options.find(option.name), nullptr) << option.name << " is not among the effective options";
  if (GetParam().multi_start) {
    EXPECT_GE(record.options.at("starts").integer(), 1);
  }
  ASSERT_TRUE(record.best.has_value());
  EXPECT_LT(*record.best->summary.cost, *record.start.cost);
}

TEST_P(EveryTrial, IsKeptAsALineThatReadsBack) {
  const TrialRecord record = run_trial(study_of(std::make_shared<WatchedProblem>()), {}, components());
  const std::string line = to_json_line(record);
  EXPECT_EQ(to_json_line(parse_record(line, "line")), line);
}

TEST_P(EveryTrial, OnAHostileProblemIsKeptAsALineToo) {
  const Evaluation no_number = {Status::ok, std::numeric_limits<double>::quiet_NaN()};
  const auto half = std::make_shared<WatchedProblem>(
      Toy{}, [=](std::span<const double> x, Evaluation result) { return x[0] > 0.5 ? no_number : result; });
  const auto nowhere =
      std::make_shared<WatchedProblem>(Toy{}, [=](std::span<const double>, Evaluation) { return no_number; });
  for (const auto& problem : {half, nowhere}) {
    const TrialRecord record = run_trial(study_of(problem), {}, components());
    EXPECT_FALSE(record.reason.empty());
    EXPECT_EQ(record.best.has_value(), problem == half);
    const std::string line = to_json_line(record);
    EXPECT_EQ(to_json_line(parse_record(line, "line")), line);
  }
}

TEST_P(EveryTrial, OnARegisteredProblemEndsNoWorseThanItStarted) {
  for (const Sample& sample : samples()) {
    const std::shared_ptr<const Problem> problem = make_problem(sample);
    if (!problem->abilities().missing(GetParam().description().needs).empty()) continue;
    const TrialRecord record = run_trial(study_of(problem), {}, components());
    EXPECT_NE(to_string(record.end), "crashed") << sample.name;
    EXPECT_LE(record.counts.evaluations, 300) << sample.name;
    ASSERT_TRUE(record.best.has_value()) << sample.name << ": " << record.reason;
    EXPECT_TRUE(problem->space().contains(record.best->x)) << sample.name;
    // A fresh, refined evaluation of the best: 1e-9 of the start's cost is what the race may have been off by.
    EXPECT_LE(*record.best->summary.cost, *record.start.cost * (1.0 + 1e-9)) << sample.name;
    EXPECT_LE(record.health.drift.value_or(0.0), 1e-9) << sample.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryTrial, testing::ValuesIn(contenders()), name_of);

}  // namespace
}  // namespace nodal::contracts
