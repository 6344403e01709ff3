// SPDX-License-Identifier: GPL-3.0-or-later
// A race on a machine whose cores others keep busy: everything that shows a time says that it is worth little.
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nodal/store.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// Two processes that compute without end on every core that this one may use: whoever else runs there gets about a
// third.
class BusyCores {
 public:
  BusyCores() {
    cpu_set_t mask;
    if (::sched_getaffinity(0, sizeof mask, &mask) != 0) return;
    for (std::size_t core = 0; core < CPU_SETSIZE; ++core)
      for (int i = 0; CPU_ISSET(core, &mask) && i < 2; ++i) burn(core);
  }
  ~BusyCores() {
    for (const pid_t process : processes_) {
      ::kill(process, SIGKILL);
      ::waitpid(process, nullptr, 0);
    }
  }
  BusyCores(const BusyCores&) = delete;
  BusyCores& operator=(const BusyCores&) = delete;

 private:
  void burn(std::size_t core) {
    const pid_t process = ::fork();
    if (process > 0) processes_.push_back(process);
    if (process != 0) return;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(core, &only);
    ::sched_setaffinity(0, sizeof only, &only);
    for (volatile unsigned turns = 0;;) turns = turns + 1;
  }

  std::vector<pid_t> processes_;
};

TEST(BusyMachine, IsNamedInTheRecordsOnTheTerminalAndOnThePage) {
  const Folder folder;
  folder.write("slow.toml", kSlowStudy);
  Output output;
  {
    const BusyCores busy;
    output = run(folder, {"compare", "slow.toml", "--jobs", "1"});
  }
  EXPECT_EQ(output.exit, 0);
  const Store store = Store::open_existing(folder.path() / "results" / "slow");
  std::size_t contaminated = 0;
  for (const TrialRecord& record : store.records())
    contaminated += contamination(record).find("of a core") != std::string::npos;
  EXPECT_EQ(contaminated, store.records().size());
  EXPECT_TRUE(contains(output.err, "contaminated: ")) << output.err;
  const std::string page = read_file(folder.path() / "results" / "slow" / "report.html");
  for (const char* part : {"6 of 6 trials did not have a processor core to themselves", "(random-search 6)",
                           "6 disturbed", "times not to be trusted: "})
    EXPECT_TRUE(contains(page, part)) << part;
}

}  // namespace
}  // namespace nodal::program
