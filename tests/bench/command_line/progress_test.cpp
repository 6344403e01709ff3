// SPDX-License-Identifier: GPL-3.0-or-later
// What a person sees while trials run: a bar on a terminal, lines elsewhere.
#include "command_line/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace nodal {
namespace {

TrialRecord finished_record() {
  TrialRecord record;
  record.optimizer = "annealing";
  record.repeat = 3;
  record.end = End::finished;
  record.reason = "144 temperatures done";
  record.best = BestPoint{7, {0.5, 0.9, 0.0174}, {}};
  record.counts.evaluations = 20880;
  record.seconds.total = record.seconds.cpu = 0.31;
  return record;
}

TEST(Progress, IsABarWithTheTimeLeftOnATerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress(true);
    progress.began(4, 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));  // so that a second is left, rounded
    progress.finished(finished_record(), 3, 4);
    progress.finished(finished_record(), 4, 4);
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(text.starts_with("2 of 4 trials are stored already\n\r")) << text;
  EXPECT_NE(text.find("█░"), std::string::npos);
  EXPECT_NE(text.find(" 3/4 1 s left  annealing"), std::string::npos) << text;
  EXPECT_NE(text.find(" 4/4 done"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n"));
}

TEST(LiveTable, HasTheBestOfEachOptimizerOnTheProblemThatRuns) {
  LiveTable table({"annealing", "gauss-newton"});
  EXPECT_TRUE(table.lines(80, 24).empty()) << "nothing has run";
  TrialRecord record = finished_record();
  record.problem = "plate";
  table.add(record);
  record.best->summary.relative_error = 0.02;
  table.add(record);
  record.end = End::failed;
  record.best.reset();
  table.add(record);
  EXPECT_EQ(table.lines(80, 24), (std::vector<std::string>{"plate        relative error   trials   failed",
                                                           "annealing           0.01740        3        1",
                                                           "gauss-newton              –        0         "}));
  EXPECT_TRUE(table.lines(80, 2).empty()) << "no room";
  record.problem = "another plate";
  table.add(record);
  EXPECT_TRUE(table.lines(80, 24)[1].starts_with("annealing                 –        1        1"));
}

TEST(Progress, DrawsItsTableAboveTheBarAndTakesItAway) {
  testing::internal::CaptureStderr();
  {
    Progress progress(true, {"annealing"});
    progress.began(4, 0);
    TrialRecord record = finished_record();
    record.problem = "plate";
    progress.finished(record, 1, 4);
    progress.finished(record, 2, 4);
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_NE(text.find("0.0174"), std::string::npos) << text;
  EXPECT_NE(text.find("\r\x1b[2A"), std::string::npos) << "the second is drawn over the first: " << text;
  EXPECT_TRUE(text.ends_with("\r\x1b[2A\x1b[J")) << text;
}

TEST(Progress, WarnsOnALineOfItsOwn) {
  testing::internal::CaptureStderr();
  {
    Progress progress(true);
    progress.began(4, 0);
    progress.warned("the store is shared");
    progress.finished(finished_record(), 1, 4);
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_NE(text.find("\nwarning: the store is shared\n\r"), std::string::npos) << text;
}

TEST(Progress, IsALinePerTrialElsewhere) {
  testing::internal::CaptureStderr();
  Progress progress(false);
  progress.began(12, 0);
  progress.finished(finished_record(), 1, 12);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "running 12 trials\n"
            "[ 1/12] annealing, repeat 3: relative error 0.0174, 20880 evaluations, 0.31 s (finished: 144 temperatures "
            "done)\n");
}

TEST(Progress, SaysWhichTimesAreNotToBeTrusted) {
  TrialRecord record = finished_record();
  record.seconds.cpu = 0.155;
  EXPECT_TRUE(trial_line(record).ends_with("(finished: 144 temperatures done); contaminated: got 0.50 of a core"))
      << trial_line(record);
  EXPECT_TRUE(trial_line(record, false).ends_with("(finished: 144 temperatures done)")) << trial_line(record, false);
}

}  // namespace
}  // namespace nodal
