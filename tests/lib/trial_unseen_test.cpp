// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/unseen.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include <nodal/trial.h>

#include "../support/messages.h"
#include "toy_study.h"

namespace nodal {
namespace {

// The fitted optimum of coordinate 0 is 0.25. "early" is met on the way there, at −0.5; "late" beyond it.
double early(std::span<const double> x) { return std::abs(x[0] + 0.5); }
double late(std::span<const double> x) { return std::abs(x[0] - 0.5); }

Study study_of(std::vector<toy::HeldOut> held_out, toy::Cost cost = toy::bowl) {
  Study study;
  study.name = "toy";
  study.budget.evaluations = 100;
  StudyProblem problem;
  problem.label = problem.kind = "bowl";
  problem.problem = std::make_shared<toy::ToyProblem>(3, std::move(cost), std::move(held_out));
  study.problems.push_back(problem);
  const Registry registry = toy::registry();
  const OptimizerDescription& halving = *registry.find_optimizer("halving");
  study.optimizers.push_back(
      {.label = "halving", .use = "halving", .options = resolve_options(halving.options, Value(), "halving")});
  return study;
}

TrialRecord run(const Study& study) { return run_trial(study, {0, 0, 0}, toy::registry()); }

double finding(const TrialRecord& record) {
  for (const Finding& found : record.health.findings)
    if (found.name == kUnseenFinding) return found.value;
  return std::nan("");
}

TEST(Unseen, IsMeasuredAtTheStartOnTheWayAndAtTheBest) {
  const TrialRecord record = run(study_of({{"early", early}, {"late", late}}));
  ASSERT_TRUE(record.unseen && record.best);
  EXPECT_EQ(record.unseen->names, (std::vector<std::string>{"early", "late"}));
  EXPECT_EQ(record.unseen->failed, 0);
  const UnseenPoint* start = record.unseen->at(0);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->errors, (std::vector<double>{1.0, 2.0}));
  EXPECT_DOUBLE_EQ(record.unseen->error(*start), std::sqrt(2.5));
  EXPECT_EQ(record.unseen->worst(*start), 1u);
  const UnseenPoint* best = record.unseen->at(record.best->evaluation);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->errors, (std::vector<double>{early(record.best->x), late(record.best->x)}));
  EXPECT_EQ(finding(record), record.unseen->error(*best));
  EXPECT_GT(record.unseen->points.size(), 10u);
}

TEST(Unseen, IsNoPartOfTimesCountsAndTrace) {
  const auto slow = [](std::span<const double>) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return 0.5;
  };
  const TrialRecord without = run(study_of({})), with = run(study_of({{"slow", slow}}));
  EXPECT_FALSE(without.unseen);
  EXPECT_TRUE(std::isnan(finding(without)));
  ASSERT_TRUE(with.unseen);
  EXPECT_GT(with.unseen->points.size(), 10u);  // which took 50 ms at least
  EXPECT_LT(with.seconds.total, 0.03);
  EXPECT_LT(with.seconds.harness, 0.03);
  EXPECT_EQ(with.key, without.key);
  EXPECT_EQ(with.counts.evaluations, without.counts.evaluations);
  EXPECT_EQ(with.work.flops, without.work.flops);
  ASSERT_EQ(with.trace.size(), without.trace.size());
  for (std::size_t i = 0; i < with.trace.size(); ++i) EXPECT_EQ(with.trace[i].quality, without.trace[i].quality);
  EXPECT_EQ(with.best->x, without.best->x);
}

TEST(Unseen, LeavesPointsOutThatAreNotToBeEvaluated) {
  const TrialRecord record = run(study_of({{"gone", early, Status::not_positive_definite}}));
  ASSERT_TRUE(record.unseen);
  EXPECT_TRUE(record.unseen->points.empty());
  EXPECT_GT(record.unseen->failed, 10);
  EXPECT_EQ(record.end, End::finished);
  EXPECT_TRUE(std::isnan(finding(record)));
}

TEST(Unseen, OfAProblemThatThrowsFailsTheTrialAndKeepsTheRest) {
  const auto throwing = [](std::span<const double>) -> double { throw std::runtime_error("no such load"); };
  const TrialRecord record = run(study_of({{"broken", throwing}}));
  EXPECT_EQ(record.end, End::failed);
  EXPECT_NE(record.reason.find("no such load"), std::string::npos);
  EXPECT_TRUE(record.best && record.best->summary.cost);
  const auto no_number = [](std::span<const double>) { return std::numeric_limits<double>::quiet_NaN(); };
  const TrialRecord other = run(study_of({{"odd", no_number}}));
  EXPECT_EQ(other.end, End::failed);
  EXPECT_NE(other.reason.find("held-out error of odd"), std::string::npos);
}

// A problem whose evaluator finds something by a name that is taken.
class Misnamed final : public Problem {
 public:
  class Finds final : public Evaluator {
   public:
    Evaluation value(std::span<const double> x) override { return {Status::ok, toy::bowl(x)}; }
    [[nodiscard]] Health health() const override {
      Health health;
      health.findings = {{"sag", 2.0}, {kUnseenFinding, 3.0}, {"drift", 4.0}};
      return health;
    }
  };
  [[nodiscard]] const Space& space() const override { return toy_.space(); }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { return std::make_unique<Finds>(); }

 private:
  toy::ToyProblem toy_;
};

TEST(Unseen, IsNoProblemsOwnFinding) {
  Study study = study_of({});
  study.problems[0].problem = std::make_shared<Misnamed>();
  const TrialRecord record = run(study);
  EXPECT_EQ(record.end, End::failed);
  EXPECT_NE(record.reason.find("a finding called 'unseen'"), std::string::npos) << record.reason;
  EXPECT_NE(record.reason.find("a finding called 'drift'"), std::string::npos) << record.reason;
  ASSERT_EQ(record.health.findings.size(), 1u);
  EXPECT_EQ(record.health.findings[0].name, "sag");
}

TEST(UnseenError, IsTheRootMeanSquare) {
  EXPECT_DOUBLE_EQ(unseen_error(std::vector{3.0, 4.0}), std::sqrt(12.5));
  EXPECT_EQ(unseen_error({}), 0.0);
}

TEST(ValidatedStop, ReportsThePointThatEverySecondOneChooses) {
  Study study = study_of({{"early", early}, {"late", late}});
  const TrialRecord whole = run(study);
  study.budget.validated = true;
  const TrialRecord record = run(study);
  EXPECT_NE(record.key, whole.key);
  ASSERT_TRUE(record.unseen && record.unseen->stop && record.best);
  // Steps halve the way from −1.5 to 0.25: −0.625 is the nearest to −0.5.
  EXPECT_DOUBLE_EQ(record.best->x[0], -0.625);
  EXPECT_EQ(record.best->evaluation, 1);
  EXPECT_EQ(record.unseen->stop->evaluation, 1);
  EXPECT_EQ(record.unseen->stop->fitted_evaluation, whole.best->evaluation);
  EXPECT_EQ(record.unseen->stop->fitted_quality, whole.trace.back().quality);
  EXPECT_DOUBLE_EQ(finding(record), 1.125);  // of "late" alone, which had no part in the choice
  EXPECT_FALSE(record.unseen->reports(0));
  EXPECT_TRUE(record.unseen->reports(1));
  // As if the race had ended there; what it cost is what choosing took.
  EXPECT_EQ(record.trace.back().evaluation, 1);
  EXPECT_EQ(record.seconds.to_best, record.trace.back().seconds);
  EXPECT_EQ(record.counts.evaluations, whole.counts.evaluations);
  EXPECT_DOUBLE_EQ(*record.best->summary.cost, toy::bowl(record.best->x));
  EXPECT_EQ(record.end, End::finished);
}

TEST(ValidatedStop, ChoosesNothingWhereNothingCanBeEvaluated) {
  Study study = study_of({{"gone", early, Status::not_positive_definite}, {"late", late}});
  const TrialRecord whole = run(study);
  study.budget.validated = true;
  const TrialRecord record = run(study);
  ASSERT_TRUE(record.unseen && record.best);
  EXPECT_FALSE(record.unseen->stop);
  EXPECT_TRUE(record.unseen->points.empty());
  EXPECT_GT(record.unseen->failed, 10);
  EXPECT_EQ(record.best->evaluation, whole.best->evaluation);
  EXPECT_EQ(record.trace.size(), whole.trace.size());
}

TEST(ValidatedStop, NeedsTwoThatAreHeldOut) {
  EXPECT_NE(validated_stop_refusal(toy::ToyProblem()).find("nothing is held out"), std::string::npos);
  EXPECT_NE(validated_stop_refusal(toy::ToyProblem(3, toy::bowl, {{"early", early}})).find("only 'early'"),
            std::string::npos);
  EXPECT_EQ(validated_stop_refusal(toy::ToyProblem(3, toy::bowl, {{"early", early}, {"late", late}})), "");
  const std::string refused = toy::message_of(
      [] { (void)toy::study("[budget]\nevaluations = 5\nstop = \"unseen\"\n[problem]\nkind = \"bowl\"\n"); });
  EXPECT_TRUE(refused.starts_with("s.toml:3")) << refused;
  EXPECT_NE(refused.find("nothing is held out"), std::string::npos) << refused;
  const std::string unknown =
      toy::message_of([] { (void)toy::study("[budget]\nstop = \"seen\"\n[problem]\nkind = \"bowl\"\n"); });
  EXPECT_TRUE(unknown.starts_with("s.toml:2")) << unknown;
}

TEST(UnseenWarning, SaysWhatIsWrongWithItsFigures) {
  const TrialRecord fine = run(study_of({{"same", [](std::span<const double> x) { return 0.1 + toy::bowl(x); }}}));
  EXPECT_EQ(unseen_warning(fine), "");
  const TrialRecord worse =
      run(study_of({{"early", early}, {"away", [](std::span<const double> x) { return 2.0 + x[0]; }}}));
  const std::string text = unseen_warning(worse);
  // At the start √((1² + 0.5²)/2), at the best √((0.75² + 2.25²)/2); least where x is −0.625.
  EXPECT_NE(text.find("unseen error 1.68 (worst: away 2.25)"), std::string::npos) << text;
  EXPECT_NE(text.find("above the start's 0.791"), std::string::npos) << text;
  EXPECT_EQ(text.find("it was least, 0.791, at evaluation 0"), std::string::npos) << text;
  TrialRecord many = worse;
  many.best->summary.relative_error = 0.01;
  EXPECT_NE(unseen_warning(many).find("168 times the fitted error"), std::string::npos) << unseen_warning(many);
  const TrialRecord risen = run(study_of({{"early", early}}));
  EXPECT_NE(unseen_warning(risen).find("it was least, 0.125, at evaluation 1"), std::string::npos)
      << unseen_warning(risen);
  EXPECT_EQ(unseen_warning(run(study_of({}))), "");
}

}  // namespace
}  // namespace nodal
