// SPDX-License-Identifier: GPL-3.0-or-later
// Trials that run again, and comparisons that run beside each other.
#include <nodal/compare.h>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "../support/messages.h"
#include "toy_compare.h"

namespace nodal {
namespace {

using namespace toy;

// Optimizers of the stored records and their attempts, as text.
std::set<std::string> attempts(const TemporaryDirectory& directory) {
  std::set<std::string> found;
  const Store store(directory.path());
  for (const TrialRecord& record : store.records())
    found.insert(record.optimizer + " " + std::to_string(record.repeat) + ": " + std::to_string(record.attempt));
  return found;
}

std::size_t lines_in(const TemporaryDirectory& directory) {
  std::size_t lines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory.path() / "trials")) {
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) ++lines;
  }
  return lines;
}

TEST(Compare, RunsOptimizersAgainWhenAsked) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("halving") + "label = \"h\"\n" + use("wanderer"), once());
  EXPECT_EQ(run(study, directory).ran, 2u);
  EXPECT_EQ(run(study, directory, {.rerun = {"wanderer"}}).ran, 1u);
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"h 0: 1", "wanderer 0: 2"}));
  EXPECT_EQ(run(study, directory, {.rerun = {"halving,wanderer"}}).ran, 2u);  // by its label or its use
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"h 0: 2", "wanderer 0: 3"}));
  EXPECT_EQ(run(study, directory, {.fresh = true}).ran, 2u);
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"h 0: 3", "wanderer 0: 4"}));
  EXPECT_EQ(lines_in(directory), 7u);  // nothing was overwritten
  EXPECT_EQ(run(study, directory).ran, 0u);
}

TEST(Compare, RunsWhatFailedAgainWhenAsked) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("throwing") + use("halving"), once());
  EXPECT_EQ(run(study, directory).ran, 2u);
  const CompareResult again = run(study, directory, {.rerun = {"failed"}});
  EXPECT_EQ(again.ran, 1u);
  EXPECT_EQ(again.failed, 1u);
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"throwing 0: 2", "halving 0: 1"}));
}

TEST(Compare, RunsWhatWasContaminatedAgainWhenAsked) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("halving") + use("wanderer"), once());
  EXPECT_EQ(run(study, directory, {.jobs = 1}).ran, 2u);
  Store store(directory.path());
  for (TrialRecord record : std::vector(store.records())) {  // whatever the machine did to them
    record.attempt = 2;
    record.conditions->pace = record.optimizer == "halving" ? 1.3 : 1.0;
    record.seconds.cpu = record.seconds.total;
    store.append(record);
  }
  EXPECT_EQ(run(study, directory, {.rerun = {"contaminated"}}).ran, 1u);
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"halving 0: 3", "wanderer 0: 2"}));
}

TEST(Compare, RefusesToRunAgainWhatItDoesNotKnow) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("halving") + "label = \"a\"\n" + use("halving") + "label = \"b\"\n");
  const auto refusal = [&](const Study& of, const std::string& word) {
    return toy::message_of([&] { (void)run(of, directory, {.rerun = {word}}); });
  };
  EXPECT_EQ(refusal(study, "c"), "--rerun: no optimizer of the study is labelled 'c'; did you mean 'a' or 'b'?");
  EXPECT_EQ(refusal(study, "halving"),
            "--rerun: several entries of the study use 'halving': 'a', 'b'; give their labels");
  StudyOverrides only;
  only.only = {"halving"};
  EXPECT_EQ(refusal(study_with(kTwo, only), "wanderer"),
            "--rerun: optimizer 'wanderer' is left out by --only; name it there, too");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(Compare, SaysAndNotesThatAnotherComparisonWritesHere) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("wanderer"));
  int began[2], end[2];
  ASSERT_EQ(::pipe(began), 0);
  ASSERT_EQ(::pipe(end), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    char byte = 'x';
    Store store(directory.path());
    store.begin(study);
    (void)!::write(began[1], &byte, 1);
    ::close(end[1]);
    (void)!::read(end[0], &byte, 1);
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(began[0], &byte, 1), 1);
  std::vector<std::string> warnings;
  CompareObserver observer;
  observer.warned = [&](const std::string& warning) { warnings.push_back(warning); };
  observer.finished = [&](const TrialRecord& record, std::size_t, std::size_t) {
    if (record.repeat == 1) {
      ::close(end[1]);
      ::waitpid(other, nullptr, 0);
    }
  };
  (void)run(study, directory, {}, observer);
  EXPECT_EQ(warnings, (std::vector<std::string>{"another comparison (process " + std::to_string(other) +
                                                ") writes to '" + directory.path().string() +
                                                "' now: they share the trials, and times taken meanwhile are marked as "
                                                "contaminated"}));
  const Store store(directory.path());
  for (const TrialRecord& record : store.records())
    EXPECT_EQ(record.conditions->beside_others, record.repeat < 2) << record.repeat;
  for (const int descriptor : {began[0], began[1], end[0]}) ::close(descriptor);
}

// Runs a comparison in a process of its own.
pid_t compare_elsewhere(const Study& study, const TemporaryDirectory& directory, const CompareOptions& options) {
  const pid_t process = ::fork();
  if (process != 0) return process;
  int status = 1;
  try {
    status = run(study, directory, options).interrupted ? 1 : 0;
  } catch (...) {
  }
  ::_exit(status);
}

TEST(Compare, SharesItsTrialsWithAnotherOne) {
  const Study study = study_with(use("wanderer") + use("halving"));
  for (const bool isolate : {true, false}) {
    const TemporaryDirectory directory;
    const CompareOptions options{.isolate = isolate};
    const pid_t other = compare_elsewhere(study, directory, options);
    const CompareResult result = run(study, directory, options);
    int status = 1;
    ::waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(result.failed, 0u);
    const Store store(directory.path());
    EXPECT_EQ(store.records().size(), all_trials(study).size());
    EXPECT_EQ(lines_in(directory), all_trials(study).size()) << "each trial ran once";
    EXPECT_FALSE(std::filesystem::exists(directory.path() / "claims")) << "whoever leaves last clears up";
  }
}

// Of two that leave at once each would see the other, had they not stopped writing first.
TEST(Compare, DoesntTakeOneThatHasStoppedWritingForAWriter) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("halving"));
  int left[2], end[2];
  ASSERT_EQ(::pipe(left), 0);
  ASSERT_EQ(::pipe(end), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    char byte = 'x';
    ::close(end[1]);
    Store store(directory.path());
    store.begin(study);
    store.leave();
    (void)!::write(left[1], &byte, 1);
    (void)!::read(end[0], &byte, 1);
    ::_exit(0);
  }
  char byte = 0;
  ASSERT_EQ(::read(left[0], &byte, 1), 1);
  std::vector<std::string> warnings;
  CompareObserver observer;
  observer.warned = [&](const std::string& warning) { warnings.push_back(warning); };
  (void)run(study, directory, {}, observer);
  EXPECT_EQ(warnings, std::vector<std::string>());
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "claims"));
  ::close(end[1]);
  ::waitpid(other, nullptr, 0);
  for (const int descriptor : {left[0], left[1], end[0]}) ::close(descriptor);
}

// Somebody holds the store, and two claims stand there: one of a comparison that has left no sign of life, one of a
// comparison that has not given any for too long.
TEST(Compare, TakesOverWhatADeadComparisonHadClaimed) {
  const TemporaryDirectory directory;
  const Study study = study_with(use("wanderer"));
  int end[2];
  ASSERT_EQ(::pipe(end), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    char byte = 0;
    ::close(end[1]);
    Store store(directory.path());
    store.begin(study);
    (void)!::read(end[0], &byte, 1);
    ::_exit(0);
  }
  Store store(directory.path());
  store.begin(study);
  while (!store.other_writer()) ::usleep(1000);
  const std::filesystem::path claims = directory.path() / "claims";
  std::filesystem::create_directories(claims);
  const std::vector<Trial> trials = all_trials(study);
  std::ofstream(claims / (trial_key(study, trials[0]) + ".1")) << "gone";
  std::ofstream(claims / (trial_key(study, trials[1]) + ".1")) << "silent";
  std::ofstream(claims / "silent.alive") << "";
  std::filesystem::last_write_time(claims / "silent.alive",
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  const CompareResult result = run(study, directory);
  EXPECT_EQ(result.ran, trials.size());
  ::close(end[1]);
  ::waitpid(holder, nullptr, 0);
  ::close(end[0]);
}

}  // namespace
}  // namespace nodal
