// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons stopped at random moments, in every way there is: nothing is lost, doubled, or stored as failed.
// A few kills of each kind; NODAL_KILLS=60 in the environment makes it sixty.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include <nodal/store.h>

#include "program.h"

namespace nodal::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStudy = R"([study]
name = "killed"
repeats = 4
[budget]
seconds = 0.02
[[problem]]
kind = "elastic"
points = { counts = [3, 3] }
[[problem]]
kind = "sphere"
dimension = 5
[[optimizer]]
use = "annealing"
[[optimizer]]
use = "random-search"
)";
constexpr std::size_t kTrials = 16;

int wanted_kills() {
  const char* set = std::getenv("NODAL_KILLS");
  return set ? std::atoi(set) : 3;
}

std::vector<pid_t> children_of(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; in >> child;) children.push_back(child);
  return children;
}

// To the program alone, or to its trials first and then to itself and its group, as a service manager does.
void send(pid_t process, int signal, bool to_all) {
  if (to_all) {
    for (const pid_t child : children_of(process)) ::kill(child, signal);
    ::kill(-process, signal);
  }
  ::kill(process, signal);
}

// Until the program has begun a trial, or has nothing to begin.
void wait_for_a_trial(pid_t process) {
  for (int i = 0; i < 1000 && children_of(process).empty(); ++i) {
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT | WNOHANG);
    if (ended.si_pid == process) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

struct Kind {
  const char* name;
  int signal;
  bool to_all;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

// Stops a comparison again and again until it has come to its end, then begins another.
class Killing : public testing::TestWithParam<Kind> {
 protected:
  Killing() { folder_.write("s.toml", kStudy); }

  Output run_until_killed(const std::string& out, std::chrono::milliseconds moment) {
    Started program(
        folder_, {"compare", "s.toml", "--out", out, "--time-lane", "0", "--jobs", std::to_string(1 + random_() % 2)});
    ::setpgid(program.process(), program.process());
    if (random_() % 8 != 0) wait_for_a_trial(program.process());  // else at its very beginning
    std::this_thread::sleep_for(moment);
    send(program.process(), GetParam().signal, GetParam().to_all);
    return program.wait();
  }

  void expect_whole(const std::string& out) {
    const Output last = run(folder_, {"compare", "s.toml", "--out", out, "--time-lane", "0"});
    EXPECT_EQ(last.exit, 0) << last.err;
    const Store store = Store::open_existing(folder_.path() / out);
    EXPECT_TRUE(store.warnings().empty()) << store.warnings().front();
    EXPECT_EQ(store.records().size(), kTrials);
    EXPECT_EQ(count_lines(folder_.path() / out / "trials"), kTrials);
    for (const TrialRecord& record : store.records()) EXPECT_FALSE(is_failure(record.end)) << record.reason;
  }

  Folder folder_;
  std::minstd_rand random_{1};
};

TEST_P(Killing, LosesDoublesAndFailsNothing) {
  int stores = 1, kills = 0;
  for (int kill = 0; kill < wanted_kills(); ++kill) {
    const std::string out = "out" + std::to_string(stores);
    const std::size_t before = count_lines(folder_.path() / out / "trials");
    const Output output = run_until_killed(out, std::chrono::milliseconds(random_() % 250));
    EXPECT_GE(count_lines(folder_.path() / out / "trials"), before);
    const bool is_stop = GetParam().signal != SIGKILL;
    // Before the comparison begins a signal does what it always does.
    EXPECT_TRUE(output.exit == 0 || output.exit == 128 + GetParam().signal || (is_stop && output.exit == 130))
        << output.exit << ": " << output.err;
    kills += output.exit != 0;
    if (output.exit == 0) expect_whole("out" + std::to_string(stores++));
  }
  expect_whole("out" + std::to_string(stores));
  RecordProperty("kills", kills);
}
INSTANTIATE_TEST_SUITE_P(AtRandomMoments, Killing,
                         testing::Values(Kind{"Kill", SIGKILL, false}, Kind{"KillAll", SIGKILL, true},
                                         Kind{"Interrupt", SIGINT, false}, Kind{"InterruptAll", SIGINT, true},
                                         Kind{"Terminate", SIGTERM, false}, Kind{"TerminateAll", SIGTERM, true},
                                         Kind{"HangUp", SIGHUP, false}, Kind{"HangUpAll", SIGHUP, true}),
                         [](const auto& kind) { return std::string(kind.param.name); });

// Stopped for as long as a trial's deadline is no time-out, and no budget spent either.
class Pausing : public testing::TestWithParam<bool> {};

TEST_P(Pausing, IsNeitherTimeoutNorSearch) {
  constexpr double kPause = 1.0;
  std::minstd_rand random(2);
  for (int stop = 0; stop < std::max(1, wanted_kills() / 3); ++stop) {
    const Folder folder;
    folder.write("s.toml", kStudy);
    Started program(folder, {"compare", "s.toml", "--out", "out"});
    ::setpgid(program.process(), program.process());
    wait_for_a_trial(program.process());
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 200));
    send(program.process(), SIGSTOP, GetParam());
    std::this_thread::sleep_for(std::chrono::duration<double>(kPause));
    send(program.process(), SIGCONT, GetParam());
    const Output output = program.wait();
    EXPECT_EQ(output.exit, 0) << output.err;
    const Store store = Store::open_existing(folder.path() / "out");
    EXPECT_EQ(store.records().size(), kTrials);
    EXPECT_EQ(count_lines(folder.path() / "out" / "trials"), kTrials);
    for (const TrialRecord& record : store.records()) {
      EXPECT_FALSE(is_failure(record.end)) << record.reason;
      EXPECT_LT(record.seconds.total, kPause) << "a trial holds the time during which it was stopped";
    }
  }
}
INSTANTIATE_TEST_SUITE_P(AtRandomMoments, Pausing, testing::Bool(),
                         [](const auto& which) { return std::string(which.param ? "EveryProcess" : "TheProgram"); });

}  // namespace
}  // namespace nodal::program
