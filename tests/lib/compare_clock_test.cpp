// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a trial's times worth something: warm-ups, one core, trials that run once more alone.
#include <nodal/compare.h>

#include <gtest/gtest.h>

#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <set>

#include <nodal/analysis.h>
#include <nodal/shard.h>

#include "toy_compare.h"

namespace nodal {
namespace {

using namespace toy;

bool allowed(std::int64_t core) {
  cpu_set_t mask;
  return ::sched_getaffinity(0, sizeof mask, &mask) == 0 && CPU_ISSET(static_cast<std::size_t>(core), &mask);
}

// But what the machine does meanwhile.
std::function<void(const std::string&)> keep_in(std::vector<std::string>& warnings) {
  return [&warnings](const std::string& warning) {
    if (!warning.starts_with("the core has become")) warnings.push_back(warning);
  };
}

// Optimizer, repeat and attempt of the stored trials, and on how many jobs they ran.
std::multiset<std::string> lane_of(const TemporaryDirectory& directory) {
  std::multiset<std::string> found;
  const Store store(directory.path());
  for (const TrialRecord& record : store.records())
    found.insert(record.optimizer + " " + std::to_string(record.repeat) + ", attempt " +
                 std::to_string(record.attempt) + ", jobs " + std::to_string(record.conditions->jobs));
  return found;
}

// `outcomes`, whichever attempt it was.
std::map<std::string, std::string> outcomes_of_any_attempt(const TemporaryDirectory& directory) {
  std::map<std::string, std::string> by_key = outcomes(directory);
  for (auto& [key, line] : by_key) {
    const std::string attempt = "\"attempt\":2,";
    if (const std::size_t at = line.find(attempt); at != std::string::npos) line.erase(at, attempt.size());
  }
  return by_key;
}

TEST(Clock, RunsEveryTrialWarmAndSaysWhere) {
  for (const int jobs : {1, 2}) {
    const TemporaryDirectory directory;
    (void)run(study_with(kTwo + use("throwing")), directory, {.jobs = jobs});
    const Store store(directory.path());
    for (const TrialRecord& record : store.records()) {
      EXPECT_GT(record.seconds.warm_up.value_or(0.0), 0.0) << record.optimizer;
      ASSERT_TRUE(record.conditions);
      EXPECT_GE(record.conditions->preempted.value_or(-1), 0);
      EXPECT_GE(record.conditions->waited.value_or(-1), 0);
      EXPECT_EQ(record.conditions->core.has_value(), jobs == 1);
      EXPECT_EQ(record.conditions->pace.has_value(), jobs == 1);
      if (jobs == 2) continue;
      EXPECT_TRUE(allowed(*record.conditions->core));
      EXPECT_GE(*record.conditions->pace, 1.0);
    }
  }
}

TEST(Clock, LeavesThisProcessWhereItMayRun) {
  cpu_set_t before, after;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  const TemporaryDirectory directory;
  (void)run(study_with(kTwo), directory);
  ASSERT_EQ(::sched_getaffinity(0, sizeof after, &after), 0);
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

// The warm-up has its own evaluator, meter and random numbers.
TEST(Clock, ChangesNoTrialByWarmingUp) {
  const Study study = study_with(kTwo);
  const TemporaryDirectory compared, alone;
  (void)run(study, compared);
  Store store(alone.path());
  for (const Trial& trial : all_trials(study)) store.append(run_trial(study, trial, registry_of_processes()));
  EXPECT_EQ(outcomes(compared), outcomes(alone));
}

TEST(Clock, DoesNotPinTrialsOfAShare) {
  const TemporaryDirectory directory;
  const Study study = study_with(kTwo);
  (void)run(study, directory, {.time_lane = 3, .keys = shard_keys(study, {1, 1})});
  const Store store(directory.path());
  ASSERT_EQ(store.records().size(), 7u);
  for (const TrialRecord& record : store.records()) EXPECT_FALSE(record.conditions->core) << record.optimizer;
}

const std::multiset<std::string> kTimed = {"halving 0, attempt 2, jobs 1",  "halving 1, attempt 2, jobs 1",
                                           "halving 2, attempt 2, jobs 1",  "wanderer 0, attempt 2, jobs 1",
                                           "wanderer 1, attempt 2, jobs 1", "wanderer 2, attempt 2, jobs 1",
                                           "wanderer 3, attempt 1, jobs 2"};

TEST(TimeLane, RunsSomeTrialsOfEveryOptimizerOnceMoreAlone) {
  const Study study = study_with(kTwo);
  const TemporaryDirectory serial, lane;
  (void)run(study, serial);
  std::vector<std::string> warnings;
  std::vector<std::size_t> timing;
  std::vector<std::pair<std::size_t, std::size_t>> finished;
  CompareObserver observer;
  observer.warned = keep_in(warnings);
  observer.timing = [&](std::size_t trials) { timing.push_back(trials); };
  observer.finished = [&](const TrialRecord&, std::size_t done, std::size_t total) {
    finished.emplace_back(done, total);
  };
  EXPECT_EQ(run(study, lane, {.jobs = 2, .time_lane = 3}, observer).ran, 13u);
  EXPECT_EQ(timing, std::vector<std::size_t>{6});
  EXPECT_EQ(finished[6], std::pair(std::size_t{7}, std::size_t{7}));
  EXPECT_EQ(finished[12], std::pair(std::size_t{13}, std::size_t{13}));
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_EQ(lane_of(lane), kTimed);
  EXPECT_EQ(outcomes_of_any_attempt(lane), outcomes(serial));
  EXPECT_EQ(run(study, lane, {.jobs = 2, .time_lane = 3}).ran, 0u);
  EXPECT_EQ(run(study, lane, {.time_lane = 4}).ran, 1u);  // the fourth
}

TEST(TimeLane, IsSpreadOverTheRepeats) {
  StudyOverrides overrides;
  overrides.repeats = 9;
  const TemporaryDirectory directory;
  (void)run(study_with(use("wanderer"), overrides), directory, {.jobs = 2, .time_lane = 3});
  std::set<int> alone;
  const Store store(directory.path());
  for (const TrialRecord& record : store.records())
    if (ran_alone(record)) alone.insert(record.repeat);
  EXPECT_EQ(alone, (std::set<int>{0, 3, 6}));
}

TEST(TimeLane, GoesOnWhereItWasInterrupted) {
  const Study study = study_with(kTwo);
  for (const std::size_t last : {7u, 9u, 12u}) {
    const TemporaryDirectory directory;
    std::atomic<bool> interrupted = false;
    CompareObserver observer;
    observer.finished = [&](const TrialRecord&, std::size_t done, std::size_t) { interrupted = done == last; };
    const CompareResult first =
        run(study, directory, {.jobs = 2, .time_lane = 3, .interrupted = &interrupted}, observer);
    EXPECT_TRUE(first.interrupted) << last;
    EXPECT_EQ(first.ran, last);
    EXPECT_EQ(run(study, directory, {.jobs = 2, .time_lane = 3}).ran, 13u - last);
    EXPECT_EQ(lane_of(directory), kTimed);
  }
}

// Two comparisons of one job each are not alone: their times wait for the next one.
TEST(TimeLane, TimesWhatRanBesideAnotherComparison) {
  const Study study = study_with(kTwo);
  const TemporaryDirectory directory;
  (void)run(study, directory);
  {
    Store store(directory.path());
    std::vector<TrialRecord> records = store.records();
    for (TrialRecord& record : records) {
      record.attempt = 2;
      record.conditions->beside_others = true;
      store.append(record);
    }
  }
  EXPECT_EQ(run(study, directory, {.time_lane = 3}).ran, 6u);
  EXPECT_EQ(run(study, directory, {.time_lane = 3}).ran, 0u);
}

TEST(TimeLane, LeavesOutWhatFailed) {
  const TemporaryDirectory directory;
  const CompareResult result =
      run(study_with(use("throwing") + use("halving"), once()), directory, {.jobs = 2, .time_lane = 3});
  EXPECT_EQ(result.ran, 3u);
  EXPECT_EQ(result.failed, 1u);
  EXPECT_EQ(lane_of(directory),
            (std::multiset<std::string>{"halving 0, attempt 2, jobs 1", "throwing 0, attempt 1, jobs 2"}));
}

// Its numbers hang on the process that it runs in.
class Fickle final : public Optimizer {
 public:
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream&) override {
    std::vector<double> x(start.begin(), start.end());
    x[0] += 1e-7 * static_cast<double>(::getpid());
    (void)meter.value(x);
    return {};
  }
};

TEST(TimeLane, SaysWhichTrialsDoSomethingElseAlone) {
  Registry registry = registry_of_processes();
  registry.add(
      OptimizerDescription{.name = "fickle", .make = [](const Options&) { return std::make_unique<Fickle>(); }});
  const Study study = parse_study(kHead + use("fickle") + use("halving"), "s.toml", registry, once());
  const TemporaryDirectory directory;
  Store store(directory.path());
  std::vector<std::string> warnings;
  CompareObserver observer;
  observer.warned = keep_in(warnings);
  (void)compare(study, registry, store, {.jobs = 2, .time_lane = 1}, observer);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("fickle, repeat 0, did something else when it ran alone: it ended 'finished'"))
      << warnings[0];
}

// Then the parent stores what trials have sent without reading it.
TEST(Compare, StoresTheSameThroughAStoreOfShortRecords) {
  const Study study = study_with(kTwo + use("throwing") + use("aborting"));
  const TemporaryDirectory whole, brief;
  (void)run(study, whole);
  Store store(brief.path(), InMemory::short_records);
  std::vector<std::string> warnings;
  CompareObserver observer;
  observer.warned = keep_in(warnings);
  EXPECT_EQ(compare(study, registry_of_processes(), store, {}, observer).failed, 8u);
  EXPECT_EQ(compare(study, registry_of_processes(), store, {.rerun = {"halving"}}, observer).ran, 3u);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_EQ(outcomes_of_any_attempt(brief), outcomes(whole));
  const Store read(brief.path());
  for (const TrialRecord& record : read.records()) {
    ASSERT_TRUE(record.conditions);
    EXPECT_EQ(record.conditions->jobs, 1);
    EXPECT_FALSE(record.conditions->build.empty());
    EXPECT_EQ(record.conditions->pace.has_value(), true);
    EXPECT_EQ(record.attempt, record.optimizer == "halving" ? 2 : 1);
  }
}

TEST(Store, KeepsShortRecordsWhereNobodyReadsTheRest) {
  const TemporaryDirectory directory;
  (void)run(study_with(kTwo), directory);
  const auto before = outcomes(directory);
  Store store(directory.path(), InMemory::short_records);
  ASSERT_EQ(store.records().size(), 7u);
  for (const TrialRecord& record : store.records()) EXPECT_TRUE(record.trace.empty());
  TrialRecord another = Store(directory.path()).records().at(0);
  another.attempt = 2;
  store.append(another);
  EXPECT_TRUE(store.find(another.key)->trace.empty());
  EXPECT_EQ(Store(directory.path()).find(another.key)->trace.size(), another.trace.size());  // the file has it
  EXPECT_EQ(outcomes_of_any_attempt(directory), before);
}

}  // namespace
}  // namespace nodal
