// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>

#include "../support/messages.h"
#include "toy_compare.h"

namespace nodal {
namespace {

using namespace toy;

TEST(Compare, RunsEveryTrialOnceAndThenNothing) {
  const TemporaryDirectory directory;
  const Study study = study_with(kTwo);
  std::vector<std::pair<std::size_t, std::size_t>> began, finished;
  CompareObserver observer;
  observer.began = [&](std::size_t total, std::size_t stored) { began.emplace_back(total, stored); };
  observer.finished = [&](const TrialRecord&, std::size_t done, std::size_t total) {
    finished.emplace_back(done, total);
  };
  const CompareResult first = run(study, directory, {}, observer);
  EXPECT_EQ(first.ran, 7u);
  EXPECT_EQ(first.failed, 0u);
  EXPECT_FALSE(first.interrupted);
  EXPECT_EQ(run(study, directory, {}, observer).ran, 0u);
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(began, (Pairs{{7, 0}, {7, 7}}));
  EXPECT_EQ(finished, (Pairs{{1, 7}, {2, 7}, {3, 7}, {4, 7}, {5, 7}, {6, 7}, {7, 7}}));
  const Store store(directory.path());
  EXPECT_EQ(store.records().size(), 7u);
  for (const Trial& trial : all_trials(study)) EXPECT_NE(store.find(trial_key(study, trial)), nullptr);
}

TEST(Compare, RunsOnlyWhatTheStoreLacks) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("wanderer")), directory).ran, 4u);
  EXPECT_EQ(run(study_with(kTwo), directory).ran, 3u);
}

TEST(Compare, GivesTheSameOutcomesHoweverItRuns) {
  const Study study = study_with(kTwo + use("throwing"));
  const TemporaryDirectory one, two, here;
  EXPECT_EQ(run(study, one, {.jobs = 1}).ran, 11u);
  EXPECT_EQ(run(study, two, {.jobs = 2}).ran, 11u);
  EXPECT_EQ(run(study, here, {.isolate = false}).ran, 11u);
  EXPECT_EQ(outcomes(one), outcomes(two));
  EXPECT_EQ(outcomes(one), outcomes(here));
}

TEST(Compare, ReadsAnyNumberOfJobsBelowOneAsOne) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("wanderer")), directory, {.jobs = -3}).ran, 4u);
}

TEST(Compare, RunsMoreJobsThanThereAreTrials) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(kTwo), directory, {.jobs = 20}).ran, 7u);
  EXPECT_EQ(Store(directory.path()).records().size(), 7u);
}

TEST(Compare, KeepsARowOfATrialThatThrows) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("throwing"), once()), directory).failed, 1u);
  EXPECT_EQ(only_record(directory).end, End::failed);
  EXPECT_EQ(only_record(directory).reason, "lost its way");
}

TEST(Compare, KeepsARowWhoseReasonIsNoUtf8) {
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory;
    EXPECT_EQ(run(study_with(use("latin"), once()), directory, {.isolate = isolate}).failed, 1u);
    EXPECT_EQ(only_record(directory).end, End::failed);
    EXPECT_EQ(only_record(directory).reason, "caf\xEF\xBF\xBD ferm\xEF\xBF\xBD");
    EXPECT_EQ(run(study_with(use("latin"), once()), directory, {.isolate = isolate}).ran, 0u);
  }
}

TEST(Compare, KeepsARowOfAProblemThatThrowsWhatIsNoException) {
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory;
    const Study study =
        toy::study("[budget]\nevaluations = 5\n[problem]\nkind = \"broken\"\n" + use("halving"), once());
    EXPECT_EQ(run(study, directory, {.isolate = isolate}).failed, 1u);
    EXPECT_EQ(only_record(directory).end, End::failed);
    EXPECT_TRUE(only_record(directory).reason.ends_with("an exception that is no std::exception"))
        << only_record(directory).reason;
  }
}

// Whatever is made anew for a trial may throw anything; the trials beside it are none the worse.
TEST(Compare, KeepsARowOfWhatCannotBeMade) {
  const auto text = [](const char* kind) {
    return std::string("[budget]\nevaluations = 5\n[problem]\nkind = \"") + kind + "\"\n";
  };
  const std::string multi_start = use("unmade") + "label = \"again\"\nmulti_start = true\n";
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory, other;
    const std::string optimizers = use("unmade") + multi_start + use("throwing-a-number") + use("halving");
    EXPECT_EQ(run(toy::study(text("bowl") + optimizers, once()), directory, {.isolate = isolate}).failed, 3u);
    const Store store(directory.path());
    ASSERT_EQ(store.records().size(), 4u);
    for (const TrialRecord& record : store.records()) {
      const bool good = record.optimizer == "halving";
      EXPECT_EQ(record.end, good ? End::budget : End::failed) << record.optimizer;
      EXPECT_EQ(record.reason, good ? "evaluations spent" : "an exception that is no std::exception");
      EXPECT_TRUE(record.start.cost.has_value()) << record.optimizer;
    }
    EXPECT_EQ(run(toy::study(text("unmade") + use("halving"), once()), other, {.isolate = isolate}).failed, 1u);
    EXPECT_EQ(only_record(other).end, End::failed);
    EXPECT_EQ(only_record(other).reason, "an exception that is no std::exception");
  }
}

TEST(Compare, KeepsARowOfATrialWhoseNumbersNoRecordCanHold) {
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory;
    const Study study =
        toy::study("[budget]\nevaluations = 5\n[problem]\nkind = \"unspeakable\"\n" + use("halving"), once());
    EXPECT_EQ(run(study, directory, {.isolate = isolate}).failed, 1u);
    EXPECT_EQ(only_record(directory).end, End::failed);
    EXPECT_EQ(only_record(directory).reason,
              "evaluations spent; the relative error of the start is nan; the relative error of the best point is nan");
  }
}

// 10 × 1e300 s in nanoseconds fits no integer: the deadline must not come out in the past.
TEST(Compare, AllowsATrialAnyNumberOfSeconds) {
  const TemporaryDirectory directory;
  StudyOverrides overrides = once();
  overrides.seconds = 1e300;
  EXPECT_EQ(run(study_with(use("halving"), overrides), directory).failed, 0u);
}

TEST(Compare, CountsStoredFailuresToo) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("throwing") + use("halving"), once());
  EXPECT_EQ(run(study, directory).failed, 1u);
  const CompareResult again = run(study, directory);
  EXPECT_EQ(again.ran, 0u);
  EXPECT_EQ(again.failed, 1u);
}

TEST(Compare, KeepsWhatWasFinishedWhenInterruptedAndGoesOnNextTime) {
  const Study study = study_with(kTwo);
  const TemporaryDirectory whole;
  (void)run(study, whole);
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory;
    std::atomic<bool> interrupted = false;
    CompareObserver observer;
    observer.finished = [&](const TrialRecord&, std::size_t done, std::size_t) { interrupted = done == 3; };
    const CompareResult first = run(study, directory, {.isolate = isolate, .interrupted = &interrupted}, observer);
    EXPECT_TRUE(first.interrupted);
    EXPECT_EQ(first.ran, 3u);
    EXPECT_EQ(Store(directory.path()).records().size(), 3u);
    interrupted = false;
    const CompareResult second = run(study, directory, {.isolate = isolate, .interrupted = &interrupted});
    EXPECT_FALSE(second.interrupted);
    EXPECT_EQ(second.ran, 4u);
    EXPECT_EQ(outcomes(directory), outcomes(whole));
  }
}

TEST(Compare, KillsWhatRunsWhenInterrupted) {
  const TemporaryDirectory directory;
  std::atomic<bool> interrupted = false;
  CompareObserver observer;
  observer.finished = [&](const TrialRecord&, std::size_t, std::size_t) { interrupted = true; };
  const CompareResult result = run(study_with(use("hanging") + use("halving"), once()), directory,
                                   {.jobs = 2, .interrupted = &interrupted}, observer);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(only_record(directory).optimizer, "halving");
  EXPECT_FALSE(has_children());
}

TEST(Compare, RunsNothingWhenInterruptedBefore) {
  const TemporaryDirectory directory;
  const std::atomic<bool> interrupted = true;
  for (const bool isolate : {true, false}) {
    const CompareResult result = run(study_with(kTwo), directory, {.isolate = isolate, .interrupted = &interrupted});
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.ran, 0u);
  }
}

TEST(Compare, LeavesNoChildRunningWhenTheStoreFails) {
  const TemporaryDirectory directory;
  CompareObserver observer;
  observer.began = [&](std::size_t, std::size_t) { std::ofstream(directory.path() / "trials") << "in the way"; };
  EXPECT_THROW(run(study_with(use("hanging") + use("halving"), once()), directory, {.jobs = 2}, observer), StoreError);
  EXPECT_FALSE(has_children());
}

TEST(Compare, LeavesNoChildRunningWhenAnObserverThrows) {
  const TemporaryDirectory directory;
  CompareObserver observer;
  observer.finished = [](const TrialRecord&, std::size_t, std::size_t) {
    throw std::runtime_error("the terminal is gone");
  };
  EXPECT_THROW(run(study_with(use("hanging") + use("halving"), once()), directory, {.jobs = 2}, observer),
               std::runtime_error);
  EXPECT_FALSE(has_children());
  EXPECT_EQ(only_record(directory).optimizer, "halving");
}

TEST(Compare, ExtendsAStoreWithMoreRepeats) {
  const TemporaryDirectory directory;
  StudyOverrides overrides;
  overrides.repeats = 2;
  EXPECT_EQ(run(study_with(kTwo, overrides), directory).ran, 4u);
  overrides.repeats = 6;
  EXPECT_EQ(run(study_with(kTwo, overrides), directory).ran, 5u);  // 3 + 6 in all
  EXPECT_EQ(Store(directory.path()).records().size(), 9u);
}

TEST(Compare, RunsOnlyTheOptimizersAskedForAndKeepsTheOthersKeys) {
  const TemporaryDirectory directory;
  StudyOverrides overrides;
  overrides.only = {"wanderer"};
  EXPECT_EQ(run(study_with(kTwo, overrides), directory).ran, 4u);
  EXPECT_EQ(Store(directory.path()).manifest().at("keys").list().size(), 7u);
  EXPECT_EQ(run(study_with(kTwo), directory).ran, 3u);
}

TEST(Compare, PutsOtherBudgetsAndSeedsBesideTheOld) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(kTwo), directory).ran, 7u);
  StudyOverrides budget, seed;
  budget.evaluations = 31;
  seed.seed = 2;
  EXPECT_EQ(run(study_with(kTwo, budget), directory).ran, 7u);
  EXPECT_EQ(run(study_with(kTwo, seed), directory).ran, 7u);
  EXPECT_EQ(run(study_with(kTwo), directory).ran, 0u);
  const Store store(directory.path());
  EXPECT_EQ(store.records().size(), 21u);
  EXPECT_EQ(store.manifest().at("keys").list().size(), 7u);  // of the last study
  EXPECT_EQ(store.manifest().at("runs").list().size(), 4u);
}

TEST(Compare, RunsAgainWhatWasCutOff) {
  const TemporaryDirectory directory;
  const Study study = study_with(kTwo);
  (void)run(study, directory);
  const std::map<std::string, std::string> before = outcomes(directory);
  const auto file = std::filesystem::directory_iterator(directory.path() / "trials")->path();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 10);
  EXPECT_EQ(run(study, directory).ran, 1u);
  EXPECT_EQ(outcomes(directory), before);
}

// Linux's pipe holds 65536 bytes: the child must be read while it writes.
TEST(Compare, KeepsARecordLargerThanAPipe) {
  const TemporaryDirectory directory;
  (void)run(study_with(use("talkative"), once()), directory);
  EXPECT_EQ(only_record(directory).end, End::finished);
  EXPECT_EQ(only_record(directory).options.at("speech").text(), std::string(300000, 'x'));
}

TEST(Compare, RefusesAStudyWithoutOptimizersOrBudget) {
  const TemporaryDirectory directory;
  EXPECT_EQ(toy::message_of([&] { (void)run(study_with(""), directory); }),
            "s.toml: the study has no optimizer to compare; add an [[optimizer]] table, e.g. use = \"annealing\"");
  EXPECT_EQ(toy::message_of([&] { (void)run(toy::study("[problem]\nkind = \"bowl\"\n" + use("halving")), directory); }),
            "s.toml: the study sets no budget; give [budget] seconds or evaluations");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace nodal
