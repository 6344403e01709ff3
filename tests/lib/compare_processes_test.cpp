// SPDX-License-Identifier: GPL-3.0-or-later
// What trials may do to their processes, and what may be done to them.
#include <nodal/compare.h>

#include <gtest/gtest.h>

#include <sched.h>
#include <signal.h>
#include <sys/time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include <nodal/provenance.h>

#include "../support/messages.h"
#include "toy_compare.h"

namespace nodal {
namespace {

using namespace toy;

TEST(Compare, KeepsARowOfATrialWhoseProcessAborts) {
  const TemporaryDirectory directory;
  const CompareResult result = run(study_with(use("aborting") + use("halving"), once()), directory);
  EXPECT_EQ(result.ran, 2u);
  EXPECT_EQ(result.failed, 1u);
  const Store store(directory.path());
  EXPECT_EQ(store.records()[0].end, End::crashed);
  EXPECT_EQ(store.records()[0].reason, "the trial's process died: signal 6 (Aborted)");
  EXPECT_EQ(store.records()[0].optimizer, "aborting");
  EXPECT_EQ(store.records()[1].end, End::budget);
}

// A program that ignores SIGPIPE for its own output doesn't decide what it does to trials.
TEST(Compare, GivesTrialsTheDefaultOfABrokenPipe) {
  const TemporaryDirectory directory;
  const auto former = ::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(run(study_with(use("piping"), once()), directory).failed, 1u);
  ::signal(SIGPIPE, former);
  EXPECT_EQ(only_record(directory).reason, "the trial's process died: signal 13 (Broken pipe)");
}

TEST(Compare, KeepsARowOfATrialWhoseProcessLeaves) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("leaving"), once()), directory).failed, 1u);
  EXPECT_EQ(only_record(directory).end, End::crashed);
  EXPECT_EQ(only_record(directory).reason, "the trial's process died: exit status 3");
}

TEST(Compare, KillsATrialThatHangs) {
  const TemporaryDirectory directory;
  StudyOverrides overrides = once();
  overrides.seconds = 0.01;
  const CompareResult result =
      run(study_with(use("hanging") + use("halving"), overrides), directory, {.grace_seconds = 0.2});
  EXPECT_EQ(result.ran, 2u);
  EXPECT_EQ(result.failed, 1u);
  const Store store(directory.path());
  EXPECT_EQ(store.records()[0].end, End::timeout);
  EXPECT_EQ(store.records()[0].reason, "killed after 0.3 s: it did not stop by itself");
  EXPECT_GT(store.records()[0].seconds.total, 0.29);
  EXPECT_EQ(store.records()[1].optimizer, "halving");
  EXPECT_FALSE(has_children());
}

TEST(Compare, KillsATrialThatClosesItsDescriptorsAndHangs) {
  const TemporaryDirectory directory;
  StudyOverrides overrides = once();
  overrides.seconds = 0.01;
  EXPECT_EQ(run(study_with(use("closing-and-hanging"), overrides), directory, {.grace_seconds = 0.2}).failed, 1u);
  EXPECT_EQ(only_record(directory).end, End::timeout);
  EXPECT_EQ(only_record(directory).reason, "killed after 0.3 s: it did not stop by itself");
  EXPECT_FALSE(has_children());
}

TEST(Compare, KeepsARowOfATrialThatClosedItsDescriptors) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("closing"), once()), directory).failed, 1u);
  EXPECT_EQ(only_record(directory).end, End::crashed);
  EXPECT_EQ(only_record(directory).reason, "the trial's process died: exit status 70");
}

TEST(Compare, IsNotReachedByTrialsThatWriteIntoWhatIsOpen) {
  const TemporaryDirectory directory;
  (void)run(study_with(kTwo + use("scribbling"), once()), directory, {.jobs = 2});
  const Store store(directory.path());
  EXPECT_TRUE(store.warnings().empty());
  ASSERT_EQ(store.records().size(), 3u);
  for (const TrialRecord& record : store.records())
    EXPECT_EQ(record.end, record.optimizer == "scribbling" ? End::crashed : End::budget) << record.reason;
}

// A record that is whole ends a trial, whoever holds its pipe, and what it has started ends with it.
TEST(Compare, WaitsForNoProcessThatATrialLeavesBehind) {
  const TemporaryDirectory directory;
  const auto began = std::chrono::steady_clock::now();
  (void)run(study_with(use("forking"), once()), directory);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  EXPECT_EQ(only_record(directory).end, End::failed);
  const std::string left = only_record(directory).reason;
  const auto is_alive = [&left] {
    std::ifstream in("/proc/" + left + "/stat");
    std::string number, name, state;
    return (in >> number >> name >> state) && state != "Z" && state != "X";
  };
  for (int i = 0; i < 100 && is_alive(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(is_alive()) << left;
}

TEST(Compare, WaitsForNoProcessThatATrialBecomes) {
  const TemporaryDirectory directory;
  const auto began = std::chrono::steady_clock::now();
  (void)run(study_with(use("daemonizing"), once()), directory);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  EXPECT_EQ(only_record(directory).end, End::crashed);
  EXPECT_EQ(only_record(directory).reason, "the trial's process ended without a record");
}

// The parent decides what becomes of a trial: `timeout`, `scancel` and terminals tell whole groups.
TEST(Compare, LetsTrialsIgnoreWhatIsMeantForTheWholeProgram) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run(study_with(use("terminated"), once()), directory).failed, 0u);
  EXPECT_EQ(only_record(directory).end, End::finished);
}

TEST(Compare, StoresNoCrashOfATrialThatAnInterruptKilled) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("killed"), once());
  EXPECT_EQ(run(study, directory).failed, 1u);
  EXPECT_EQ(only_record(directory).reason, "the trial's process died: signal 9 (Killed)");
  // The interrupt comes a moment after the death that has the same cause.
  const TemporaryDirectory other;
  std::atomic<bool> interrupted = false;
  CompareObserver observer;
  static std::atomic<bool>* flag = nullptr;
  flag = &interrupted;
  ::signal(SIGALRM, [](int) { flag->store(true); });
  const itimerval soon{{0, 0}, {0, 60000}};
  observer.began = [&](std::size_t, std::size_t) { ::setitimer(ITIMER_REAL, &soon, nullptr); };
  const CompareResult result = run(study, other, {.interrupted = &interrupted}, observer);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.ran, 0u);
  EXPECT_TRUE(Store(other.path()).records().empty());
}

TEST(Compare, RunsATrialThatWasStoppedAgainButNotForEver) {
  const TemporaryDirectory directory;
  std::vector<std::string> warnings;
  CompareObserver observer;
  observer.warned = [&](const std::string& warning) { warnings.push_back(warning); };
  EXPECT_EQ(run(study_with(use("napping"), once()), directory, {}, observer).ran, 1u);
  EXPECT_EQ(warnings,
            std::vector<std::string>(3, "napping, repeat 0, was stopped and continued while it ran: it runs again"));
  const TrialRecord record = only_record(directory);
  EXPECT_EQ(record.end, End::finished);
  ASSERT_TRUE(record.conditions);
  EXPECT_TRUE(record.conditions->stopped);
  EXPECT_TRUE(contamination(record).starts_with("was stopped while it ran")) << contamination(record);
}

TEST(Compare, KillsATrialThatStaysStopped) {
  const TemporaryDirectory directory;
  StudyOverrides overrides = once();
  overrides.seconds = 0.01;
  (void)run(study_with(use("stopping"), overrides), directory, {.grace_seconds = 0.2});
  EXPECT_EQ(only_record(directory).end, End::timeout);
  EXPECT_EQ(only_record(directory).reason, "killed after 0.3 s: its process was stopped by a signal");
}

// Also under taskset, or in a container with some of the machine's cores: here one is all that is allowed.
TEST(Compare, NotesTheConditionsOfEveryTrial) {
  const Value here = provenance();
  cpu_set_t former, allowed;
  ASSERT_EQ(::sched_getaffinity(0, sizeof former, &former), 0);
  CPU_ZERO(&allowed);
  for (int core = 0; CPU_COUNT(&allowed) == 0; ++core)
    if (CPU_ISSET(core, &former)) CPU_SET(core, &allowed);
  ASSERT_EQ(::sched_setaffinity(0, sizeof allowed, &allowed), 0);
  for (const int jobs : {1, 2, 64}) {
    const TemporaryDirectory directory;
    (void)run(study_with(kTwo), directory, {.jobs = jobs});
    const Store store(directory.path());
    ASSERT_EQ(store.records().size(), 7u);
    for (const TrialRecord& record : store.records()) {
      ASSERT_TRUE(record.conditions);
      EXPECT_EQ(record.conditions->build, build_id(here));
      EXPECT_EQ(record.conditions->processor, here.at("processor").text());
      EXPECT_EQ(record.conditions->jobs, std::min(jobs, 7));
      EXPECT_EQ(record.conditions->cores, CPU_COUNT(&allowed));
      EXPECT_FALSE(record.conditions->beside_others || record.conditions->stopped);
      EXPECT_EQ(record.attempt, 1);
    }
  }
  ::sched_setaffinity(0, sizeof former, &former);
}

}  // namespace
}  // namespace nodal
