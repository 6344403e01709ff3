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
