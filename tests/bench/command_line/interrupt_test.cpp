// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C loses nothing that finished, and the same command goes on from there.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include <nodal/store.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, ComparisonKeepsWhatFinishedAndGoesOnLater) {
  const Folder folder;
  folder.write("slow.toml", kSlowStudy);
  const std::filesystem::path trials = folder.path() / "results" / "slow" / "trials";
  Started program(folder, {"compare", "slow.toml"});
  const bool began = wait_for_lines(trials, 2);
  ::kill(program.process(), GetParam());
  const Output output = program.wait();
  ASSERT_TRUE(began);
  EXPECT_EQ(output.exit, 130) << output.err;
  const std::size_t kept = count_lines(trials);
  EXPECT_GE(kept, 2u);
  EXPECT_LT(kept, 6u);
  EXPECT_NE(output.err.find("interrupted: " + std::to_string(kept) +
                            " trials of this run are stored in 'results/slow'; the same "
                            "command goes on from there\n"),
            std::string::npos)
      << output.err;

  const Output again = run(folder, {"compare", "slow.toml"});
  EXPECT_EQ(again.exit, 0);
  EXPECT_TRUE(again.err.starts_with(std::to_string(kept) + " of 6 trials are stored already\n")) << again.err;
  const Store store = Store::open_existing(folder.path() / "results" / "slow");
  EXPECT_TRUE(store.warnings().empty());
  std::set<std::string> keys;
  for (const TrialRecord& record : store.records()) keys.insert(record.key);
  EXPECT_EQ(keys.size(), 6u);
  EXPECT_EQ(count_lines(trials), 6u);
}
INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_P(Interrupted, VerificationLeavesNothingBehind) {
  const Folder folder;
  folder.write("slow.toml", kSlowStudy);
  EXPECT_EQ(run(folder, {"compare", "slow.toml"}).exit, 0);
  const std::filesystem::path scratch = folder.path() / "scratch";
  std::filesystem::create_directory(scratch);
  ::setenv("TMPDIR", scratch.c_str(), 1);
  Started program(folder, {"verify", "results/slow"});
  ::unsetenv("TMPDIR");
  bool began = false;
  for (int i = 0; i < 3000 && !began; ++i, ::usleep(10000))
    for (const auto& entry : std::filesystem::directory_iterator(scratch))
      began = began || std::filesystem::exists(entry.path() / "manifest.json");
  ::kill(program.process(), GetParam());
  const Output output = program.wait();
  ASSERT_TRUE(began);
  EXPECT_EQ(output.exit, 130) << output.out << output.err;
  EXPECT_TRUE(std::filesystem::is_empty(scratch));
}

// Killed outright it leaves whole lines, and perhaps one that is cut off.
TEST(Killed, ComparisonGoesOnFromWhatIsWhole) {
  const Folder folder;
  folder.write("slow.toml", kSlowStudy);
  const std::filesystem::path trials = folder.path() / "results" / "slow" / "trials";
  Started program(folder, {"compare", "slow.toml"});
  const bool began = wait_for_lines(trials, 1);
  ::kill(program.process(), SIGKILL);
  EXPECT_EQ(program.wait().exit, 128 + SIGKILL);
  ASSERT_TRUE(began);
  // What a power cut may leave: half a record at the end of the file.
  for (const auto& entry : std::filesystem::directory_iterator(trials)) {
    const std::string text = read_file(entry.path());
    std::filesystem::resize_file(entry.path(), text.size() - 20);
  }
  const Output again = run(folder, {"compare", "slow.toml"});
  EXPECT_EQ(again.exit, 0) << again.err;
  EXPECT_NE(again.err.find("a line that is no whole record was dropped; its trial counts as not run"),
            std::string::npos)
      << again.err;
  const Store store = Store::open_existing(folder.path() / "results" / "slow");
  EXPECT_EQ(store.records().size(), 6u);
}

}  // namespace
}  // namespace nodal::program
