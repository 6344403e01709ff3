// SPDX-License-Identifier: GPL-3.0-or-later
// Whose results a store holds, and what happens to it while a comparison runs.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include <nodal/store.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

int shell(const Folder& folder, const std::string& command) {
  const int status = std::system(("cd '" + folder.path().string() + "' && " + command).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Removed, StoreIsNoticed) {
  const Folder folder;
  folder.write("slow.toml", kSlowStudy);
  const std::filesystem::path store = folder.path() / "results" / "slow";
  Started program(folder, {"compare", "slow.toml"});
  const bool began = wait_for_lines(store / "trials", 1);
  std::filesystem::rename(store, folder.path() / "gone");  // at once; removing takes its time
  std::filesystem::remove_all(folder.path() / "gone");
  const Output output = program.wait();
  ASSERT_TRUE(began);
  EXPECT_EQ(output.exit, 2);
  EXPECT_NE(output.err.find("the store 'results/slow' was moved or removed while trials ran"), std::string::npos)
      << output.err;
  EXPECT_FALSE(std::filesystem::exists(store));
}

// What some supervisors do: the first files that are opened must not be taken for standard output.
TEST(ClosedStandardDescriptors, AreNotTheStores) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(shell(folder, "'" NODAL_PROGRAM "' compare quick.toml <&- >&- 2>&-"), 2);  // the table could not be written
  const Store store = Store::open_existing(folder.path() / "results" / "quick");
  EXPECT_TRUE(store.warnings().empty());
  EXPECT_EQ(store.records().size(), 4u);
  EXPECT_EQ(count_lines(folder.path() / "results" / "quick" / "trials"), 4u);
}

// By whatever name: what a shell sends to a log stays in it.
TEST(Export, IntoStandardOutputIsAddedToIt) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  for (const std::string name : {"/dev/stdout", "/dev/fd/1"}) {
    const std::string fit = "'" NODAL_PROGRAM "' fit quick.toml --with annealing --evaluations 5 --export " + name;
    ASSERT_EQ(shell(folder, "{ echo before; " + fit + "; echo after; } >log 2>stderr"), 0);
    const std::string log = read_file(folder.path() / "log");
    EXPECT_TRUE(log.starts_with("before\n{\"schema\": 1,")) << name << log;
    EXPECT_TRUE(log.ends_with("after\n")) << name << log;
  }
}

TEST(Rerun, SupersedesWhatWasStored) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  ASSERT_EQ(run(folder, {"compare", "quick.toml"}).exit, 0);
  const Output again = run(folder, {"compare", "quick.toml", "--rerun", "annealing"});
  EXPECT_EQ(again.exit, 0) << again.err;
  EXPECT_TRUE(again.err.starts_with("2 of 4 trials are stored already\nrunning 2 trials\n")) << again.err;
  const Output fresh = run(folder, {"compare", "quick.toml", "--fresh"});
  EXPECT_EQ(fresh.exit, 0) << fresh.err;
  EXPECT_TRUE(fresh.err.starts_with("running 4 trials\n")) << fresh.err;
  const std::filesystem::path store = folder.path() / "results" / "quick";
  EXPECT_EQ(Store::open_existing(store).records().size(), 4u);
  EXPECT_EQ(count_lines(store / "trials"), 10u);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--rerun", "anealing"}).err,
            "nodal: --rerun: no optimizer of the study is labelled 'anealing'; did you mean 'annealing'?\n");
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--rerun", "failed", "--fresh"}).exit, 2);
}

// What users do: they change their optimizer, build their program again, and compare.
TEST(ChangedProgram, IsToldOnConsoleAndPage) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  ASSERT_EQ(run(folder, {"compare", "quick.toml"}).exit, 0);
  const std::filesystem::path changed = folder.path() / "changed";
  std::filesystem::copy_file(NODAL_PROGRAM, changed);
  std::ofstream(changed, std::ios::app | std::ios::binary) << "changed";
  ASSERT_EQ(shell(folder, "./changed compare quick.toml >stdout 2>stderr"), 0);
  const std::string said = read_file(folder.path() / "stderr");
  EXPECT_NE(said.find("warning: 'results/quick' holds results of another build (revision "), std::string::npos) << said;
  EXPECT_NE(said.find("annealing (2), random-search (2). Results and times may differ; --rerun LABEL or --fresh runs "
                      "them again\n"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("4 of 4 trials are stored already"), std::string::npos) << said;
  const std::filesystem::path page = folder.path() / "results" / "quick" / "report.html";
  EXPECT_NE(read_file(page).find("holds results of another build"), std::string::npos);
  ASSERT_EQ(shell(folder, "./changed compare quick.toml --fresh >stdout 2>stderr"), 0);
  EXPECT_EQ(read_file(page).find("holds results of another build"), std::string::npos);
  EXPECT_TRUE(Store::open_existing(folder.path() / "results" / "quick").warnings().empty());
}

TEST(TwoComparisons, SayThatTheyAreTwo) {
  const Folder one, two;
  for (const Folder* folder : {&one, &two}) folder->write("slow.toml", kSlowStudy);
  const std::string store = (one.path() / "out").string();
  Started first(one, {"compare", "slow.toml", "--out", store, "--repeats", "12"});
  ASSERT_TRUE(wait_for_lines(store + "/trials", 1));
  Started second(two, {"compare", "slow.toml", "--out", store, "--repeats", "2", "--seed", "5"});
  const pid_t pids[] = {first.process(), second.process()};
  const Output of_second = second.wait(), of_first = first.wait();
  EXPECT_EQ(of_first.exit, 0);
  EXPECT_EQ(of_second.exit, 0);
  const auto warning = [&](pid_t other) {
    return "warning: another comparison (process " + std::to_string(other) + ") writes to '" + store + "' now";
  };
  EXPECT_NE(of_first.err.find(warning(pids[1])), std::string::npos) << of_first.err;
  EXPECT_NE(of_second.err.find(warning(pids[0])), std::string::npos) << of_second.err;
}

TEST(TwoStudies, OfOneNameAreTold) {
  const Folder folder;
  folder.write("a.toml", kQuickStudy);
  folder.write("b.toml", kQuickStudy + "\n# another one\n");
  ASSERT_EQ(run(folder, {"compare", "a.toml"}).exit, 0);
  const Output output = run(folder, {"compare", "b.toml"});
  EXPECT_EQ(output.exit, 0);
  EXPECT_NE(output.err.find("warning: 'results/quick' holds results of the study 'quick' from '"), std::string::npos)
      << output.err;
  EXPECT_NE(output.err.find("a.toml'; this one is 'quick' from '"), std::string::npos) << output.err;
}

}  // namespace
}  // namespace nodal::program
