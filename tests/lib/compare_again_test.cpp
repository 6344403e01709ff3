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
  TrialRecord disturbed = Store(directory.path()).records().at(0);
  disturbed.attempt = 2;
  disturbed.seconds.total = 1.0;
  disturbed.seconds.cpu = 0.5;
  Store(directory.path()).append(disturbed);
  EXPECT_EQ(run(study, directory, {.rerun = {"contaminated"}}).ran, 1u);
  EXPECT_EQ(attempts(directory), (std::set<std::string>{"halving 0: 3", "wanderer 0: 1"}));
  EXPECT_EQ(run(study, directory, {.rerun = {"contaminated"}}).ran, 0u);
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
  EXPECT_EQ(warnings,
            (std::vector<std::string>{"another comparison (process " + std::to_string(other) + ") writes to '" +
                                      directory.path().string() +
                                      "' now: both may run the same trials, and times taken meanwhile are marked as "
                                      "contaminated"}));
  const Store store(directory.path());
  for (const TrialRecord& record : store.records())
    EXPECT_EQ(record.conditions->beside_others, record.repeat < 2) << record.repeat;
  for (const int descriptor : {began[0], began[1], end[0]}) ::close(descriptor);
}

}  // namespace
}  // namespace nodal
