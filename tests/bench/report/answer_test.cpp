// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/answer.h>

#include <gtest/gtest.h>

#include <numeric>

#include <nodal/statistics/two_samples.h>

#include <report/report.h>

#include "../../support/count.h"
#include "fixture.h"
#include "made_store.h"

namespace nodal::report {
namespace {

ReportData collect_one(const MadeStore& made) {
  std::vector<Store> stores;
  stores.push_back(made.write());
  return collect(stores, Registry());
}

using toy::count;

// Eight starts; `sure` goes down at once, `slow` after 2 ms and not as far.
void race(MadeStore& made, const std::string& problem, int repeats = 8) {
  for (int r = 0; r < repeats; ++r) {
    const double start = 4.0 + r;
    made.add(problem, "slow", r, {{20, 3.0 + 0.11 * r}, {500, 2.0 + 0.11 * r}}, start);
    made.add(problem, "sure", r, {{5, 2.5 + 0.1 * r}, {300, 1.0 + 0.1 * r}}, start);
  }
}

// Every figure of a sentence from the records alone.
TEST(Answer, SaysWhatTheRecordsSay) {
  MadeStore made;
  race(made, "plate");
  const ReportData data = collect_one(made);
  const std::vector<AnswerRow> rows = answer_rows(data.answer.verdicts, data.answer.scope, "G");
  // Within a millisecond, ten evaluations: `slow` is at its starts 4 … 11, `sure` at 2.5 … 3.2. The median of eight is
  // halfway between the fourth and the fifth, its interval from the first to the last. All eight differences have one
  // sign: p = 2/2⁸. Of 64 pairs all have `slow` above.
  ASSERT_EQ(data.answer.verdicts.size(), 7u);
  EXPECT_EQ(rows.at(0).sentence(),
            "With 1 ms take sure (G 2.850 [2.500, 3.200], 8 observations); next slow: 7.500 (p = 0.0078, Â = 1.00).");
  // From 2 ms on `slow` is at 3.0, 3.11, … 3.77. Of 64 pairs 60 have it above, and one, 3.0, is equal. Over the least
  // of all, 1, the medians are 1.85 and 2.385: less than twofold.
  EXPECT_EQ(rows.at(1).sentence(),
            "With 10 ms, 100 evaluations take sure (G 2.850 [2.500, 3.200], 8 observations); next slow: 3.385 (p = "
            "0.0078, Â = 0.95, less than twofold by 8: 20 or more would be needed).");
  // From 50 ms on `sure` is at 1.0 … 1.7 and `slow` at 2.0 … 2.77.
  EXPECT_EQ(rows.at(2).sentence(),
            "With 0.1 s, 0.5 s (the budget), 1,000 evaluations, all 5,000 evaluations take sure (G 1.350 [1.000, "
            "1.700], 8 observations); next slow: 2.385 (p = 0.0078, Â = 1.00).");
  EXPECT_EQ(rows.size(), 3u);
}

TEST(Answer, SaysWhatItHoldsFor) {
  MadeStore made;
  race(made, "plate");
  made.records()[0].seconds.cpu = 0.1;
  made.records()[1].end = End::failed;
  for (TrialRecord& record : made.records()) record.conditions = Conditions{"b", "A Processor", 1, 2, false, false};
  for (const char* began : {"2026-11-28T08:00:00Z", "2026-11-27T08:00:00Z"}) {
    Value run;
    run.set("began", began);
    made.runs.push_back(run);
  }
  const Answer answer = collect_one(made).answer;
  EXPECT_EQ(scope_lines(answer),
            (std::vector<std::string>{"Holds for 1 problem (plate), 8 observations of each optimizer, budget 500 ms or "
                                      "5,000 evaluations, A Processor, 2026-11-27 to 2026-11-28.",
                                      "Of 16 trials 1 disturbed and 1 failed."}));
}

TEST(Answer, OverProblemsItSaysRanksAndOnHowMany) {
  MadeStore made;
  for (const char* problem : {"a", "b", "c"}) race(made, problem);
  const ReportData data = collect_one(made);
  const AnswerRow first = answer_rows(data.answer.verdicts, data.answer.scope, "G").front();
  EXPECT_EQ(first.value, "mean rank 1.0; least or tied on 3 of 3 problems");
  EXPECT_EQ(first.next, "slow: mean rank 2.0 (p < 0.001, Â = 1.00)");
  EXPECT_EQ(data.answer.problems.size(), 3u);
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "alone</summary>"), 3u);
  EXPECT_EQ(count(page, "Friedman"), 1u);
}

// From one start, as random methods do: on `a` all of eight are apart, z = (32 − ½)/√(64·17/12) = 3.3082; on `b` they
// are the same. Of two tests Holm makes twice 0.000939. Â over both: (1 + ½)/2.
TEST(Answer, OverProblemsWithoutSharedStartsItSaysWhereOneIsTold) {
  MadeStore made;
  for (int r = 0; r < 8; ++r) {
    made.add("a", "sure", r, {{5, 1.0 + 0.1 * r}});
    made.add("a", "slow", r, {{6, 3.0 + 0.1 * r}});
    made.add("b", "sure", r, {{5, 1.0 + 0.1 * r}});
    made.add("b", "slow", r, {{6, 1.0 + 0.1 * r}});
  }
  const ReportData data = collect_one(made);
  const AnswerRow row = answer_rows(data.answer.verdicts, data.answer.scope, "G").front();
  EXPECT_EQ(row.next, "slow: mean rank 1.8 (told on a alone: p = 0.0019, Â = 0.75)");
  const std::string page = report_html(data);
  EXPECT_EQ(count(page, "Holm&#39;s adjustment is over pairs and problems") +
                count(page, "Holm's adjustment is over pairs and problems"),
            1u);
  EXPECT_EQ(count(page, "are tested over all problems together"), 0u);
}

TEST(Answer, OverProblemsItCountsAmongWhoHasTriedAll) {
  MadeStore made;
  for (const char* problem : {"a", "b"}) race(made, problem);
  for (int r = 0; r < 8; ++r) {
    made.add("a", "only a", r, {{2, 0.5}}, 4.0 + r);
    made.add("b", "only b", r, {{2, 0.5}}, 4.0 + r);
  }
  const ReportData data = collect_one(made);
  EXPECT_EQ(answer_rows(data.answer.verdicts, data.answer.scope, "G").front().value,
            "mean rank 1.0; least or tied on 2 of 2 problems");
  EXPECT_EQ(count(report_html(data), "<p>4 optimizers on 2 problems, 48 trials."), 1u);
}

TEST(Answer, ATestAgainstTheMediansIsNamed) {
  MadeStore made;
  made.add("plate", "a", 0, {{5, 2.0}}, 20.0);
  made.add("plate", "b", 0, {{5, 10.0}}, 20.0);
  for (int r = 1; r < 12; ++r) {
    made.add("plate", "a", r, {{5, 2.0 + 0.41 * r}}, 20.0 + r);
    made.add("plate", "b", r, {{5, 2.0 + 0.4 * r}}, 20.0 + r);
  }
  const ReportData data = collect_one(made);
  const AnswerRow row = answer_rows(data.answer.verdicts, data.answer.scope, "G").front();
  EXPECT_EQ(row.take, "a");
  EXPECT_EQ(row.ties, "b (a test finds it better: p = 0.034)");
  EXPECT_EQ(count(report_html(data), "medians and test disagree"), 1u);
}

TEST(Answer, StandsFirstOnThePageAndInAFewLinesOnTheTerminal) {
  MadeStore made;
  race(made, "plate");
  const ReportData data = collect_one(made);
  const std::string page = report_html(data);
  ASSERT_NE(page.find("<h2>Which to take</h2>"), std::string::npos);
  EXPECT_EQ(page.find("<h2>Which to take</h2>"), page.find("<h2>"));
  for (const AnswerRow& row : answer_rows(data.answer.verdicts, data.answer.scope, "quality"))
    EXPECT_NE(page.find("<th scope=\"row\">" + row.limits + "</th><td><b>" + row.take + "</b>"), std::string::npos);
  const std::string lines = answer_lines(data);
  EXPECT_GE(count(lines, "\n"), 3u);
  EXPECT_LE(count(lines, "\n"), 10u);
  EXPECT_NE(lines.find("  With 1 ms take sure"), std::string::npos);
}

TEST(Answer, OneObservationEachIsSaid) {
  MadeStore made;
  for (int r = 0; r < 3; ++r) {
    made.add("plate", "a", r, {{5, 2.0}});
    made.add("plate", "b", r, {{5, 3.0}});
  }
  made.deterministic = {"a", "b"};
  const ReportData data = collect_one(made);
  EXPECT_EQ(answer_rows(data.answer.verdicts, data.answer.scope, "G").at(0).sentence(),
            "With 1 ms, 10 ms, 0.1 s, 0.5 s (the budget), 100 evaluations, 1,000 evaluations, all 5,000 evaluations "
            "take a (G 2.000, 1 observation); next b: 3.000 (one observation: no test).");
}

TEST(Answer, TiesAreNamedOrCounted) {
  MadeStore made;
  for (const char* label : {"a", "b", "c", "d", "e", "f"})
    for (int r = 0; r < 3; ++r) made.add("plate", label, r, {{5, 2.0}}, 4.0 + r);
  const ReportData data = collect_one(made);
  EXPECT_EQ(answer_rows(data.answer.verdicts, data.answer.scope, "G").at(0).ties,
            "b (equal digits), c (equal digits), d (equal digits), e (equal digits), f (equal digits)");
  EXPECT_EQ(answer_rows(data.answer.verdicts, data.answer.scope, "G", 2).at(0).ties,
            "b (equal digits), c (equal digits), 3 others");
}

TEST(Answer, AClaimBelowTwofoldByFewIsCalledThat) {
  MadeStore made;
  for (int r = 0; r < 8; ++r) {
    made.add("plate", "a", r, {{5, 2.0 + 0.1 * r}}, 4.0 + r);
    made.add("plate", "b", r, {{5, 2.31 + 0.11 * r}}, 4.0 + r);
  }
  const ReportData data = collect_one(made);
  EXPECT_EQ(answer_rows(data.answer.verdicts, data.answer.scope, "G").at(0).next,
            "b: 2.695 (p = 0.0078, Â = 0.84, less than twofold by 8: 20 or more would be needed)");
}

TEST(Answer, WhereNothingCanBeTakenItSaysWhy) {
  MadeStore made;
  made.add("plate", "a", 0, {}).end = End::failed;
  ReportData data = collect_one(made);
  EXPECT_NE(answer_lines(data).find("no optimizer has a median result within that."), std::string::npos);
  MadeStore still;
  still.add("plate", "a", 0, {});
  data = collect_one(still);
  EXPECT_NE(answer_lines(data).find("no optimizer has improved its start within that."), std::string::npos);
}

TEST(Answer, OfNoTrialThereIsNone) {
  EXPECT_TRUE(make_answer({}, {}).empty());
  EXPECT_EQ(answer_lines(ReportData{}), "");
  EXPECT_EQ(count(report_html(fixture::make_data()), "Which to take"), 0u);
}

TEST(Answer, ABudgetThatNobodyKnowsIsTheWholeTrial) {
  MadeStore made;
  race(made, "plate");
  made.study_text = "what is this";
  const Answer answer = collect_one(made).answer;
  EXPECT_FALSE(answer.scope.seconds);
  EXPECT_EQ(limit_text(answer.verdicts.back().limit, answer.scope), "all evaluations");
  EXPECT_EQ(limit_text({Axis::seconds, {}}, answer.scope), "the whole trial");
}

TEST(Answer, IsTheSameAtEveryCall) {
  MadeStore made;
  race(made, "a");
  race(made, "b");
  EXPECT_EQ(report_html(collect_one(made)), report_html(collect_one(made)));
}

// One that copies another, one that claims what isn't so, one whose core was taken.
TEST(Planted, AliasLiarAndDisturbedAreNamedOnThePage) {
  MadeStore made;
  std::vector<std::pair<std::int64_t, double>> way;
  for (int i = 1; i <= 8; ++i) way.emplace_back(10 * i, 4.0 - 0.3 * i);
  made.add("plate", "honest", 0, way);
  made.add("plate", "copy", 0, way);
  TrialRecord& liar = made.add("plate", "liar", 0, {{7, 3.0}, {11, 2.9}});
  liar.claimed = ClaimRecord{0.001, true, 5000, "converged"};
  made.add("plate", "disturbed", 0, {{9, 3.5}}).seconds.cpu = 0.05;
  const std::string page = report_html(collect_one(made));
  EXPECT_EQ(count(page, "honest and copy are one: they found the same qualities at the same evaluations"), 1u);
  EXPECT_EQ(count(page, "liar claims a cost of 0.001 where a fresh evaluation of its best point says 0.26281"), 1u);
  EXPECT_EQ(count(page, "† 1 of 4 trials did not have a processor core to themselves"), 1u);
  EXPECT_EQ(count(page, "disturbed †"), 1u);
  EXPECT_EQ(count(page, "Of 4 trials 1 disturbed."), 1u);
}

}  // namespace
}  // namespace nodal::report
