// SPDX-License-Identifier: GPL-3.0-or-later
// Stores that become one, and studies that were set or joined when they ran.
#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include <nodal/store.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

TEST(Merge, MakesAStoreThatGoesOnLikeAnyOther) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "a", "--only", "annealing"}).exit, 0);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "b", "--only", "random-search"}).exit, 0);
  const Output merged = run(folder, {"merge", "a", "b", "--out", "c"});
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_TRUE(contains(merged.out, "4 trials of 2 stores are in 'c'")) << merged.out;
  const Store store = Store::open_existing(folder.path() / "c");
  EXPECT_EQ(store.records().size(), 4u);
  EXPECT_TRUE(store.warnings().empty());
  const Output again = run(folder, {"compare", "quick.toml", "--out", "c"});
  EXPECT_EQ(again.exit, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "4 of 4 trials")) << again.err;
  EXPECT_EQ(run(folder, {"report", "c"}).exit, 0);
}

TEST(Merge, RefusesADirectoryThatHoldsSomethingAndProblemsThatDiffer) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "a"}).exit, 0);
  const Output full = run(folder, {"merge", "a", "--out", "a"});
  EXPECT_EQ(full.exit, 2);
  EXPECT_TRUE(contains(full.err, "'a' is not empty")) << full.err;
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "b", "--set", "problem.material.poisson=0.2"}).exit, 0);
  const Output differing = run(folder, {"merge", "a", "b", "--out", "c"});
  EXPECT_EQ(differing.exit, 2);
  EXPECT_TRUE(contains(differing.err, "mean different problems by the label 'elastic'")) << differing.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "c"));
}

// Of the store 'a', the first trial of annealing.
void spoil_one(const Folder& folder, void (*forge)(TrialRecord&)) {
  bool first = true;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "a" / "trials")) {
    std::istringstream lines(read_file(entry.path()));
    std::string spoiled;
    for (std::string line; std::getline(lines, line);) {
      TrialRecord record = parse_record(line, "line");
      if (record.optimizer == "annealing" && std::exchange(first, false)) forge(record);
      spoiled += to_json_line(record) + "\n";
    }
    folder.write("a/trials/" + entry.path().filename().string(), spoiled);
  }
  EXPECT_FALSE(first);
}

TEST(Verify, RunsTrialsAgainAndComparesThem) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--evaluations", "200", "--out", "a"}).exit, 0);
  const Output same = run(folder, {"verify", "a"});
  EXPECT_EQ(same.exit, 0) << same.out << same.err;
  EXPECT_TRUE(contains(same.out, "4 of 4 trials do the same again, to the last bit")) << same.out;
  EXPECT_TRUE(contains(run(folder, {"verify", "a", "--trials", "1"}).out, "1 of 1 trials")) << same.out;
  // The last digits of one trial, of its way, its best and what it cost.
  using Forge = void (*)(TrialRecord&);
  const Forge forgeries[] = {[](TrialRecord& r) { r.trace.at(1).quality *= 1.0 + 1e-14; },
                             [](TrialRecord& r) { *r.best->summary.cost *= 1.0 - 1e-14; },
                             [](TrialRecord& r) { r.work.flops *= 1.0 - 1e-14; },
                             [](TrialRecord& r) { r.counts.evaluations = 0; }};
  for (const Forge forge : forgeries) {
    const Folder spoiled;
    std::filesystem::copy(folder.path(), spoiled.path(), std::filesystem::copy_options::recursive);
    spoil_one(spoiled, forge);
    const Output differs = run(spoiled, {"verify", "a"});
    EXPECT_EQ(differs.exit, 1) << differs.out << differs.err;
    EXPECT_TRUE(contains(differs.out, "DIFFERS  annealing on elastic, repeat")) << differs.out;
    EXPECT_TRUE(contains(differs.out, "3 of 4 trials do the same again")) << differs.out;
  }
}

// What the command line set is drawn again as it ran, not as the file has it.
TEST(Report, DrawsWhatWasSetAndIncluded) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  folder.write("study.toml", "include = \"quick.toml\"\n[study]\nname = \"mine\"\n");
  EXPECT_EQ(run(folder, {"compare", "study.toml", "--set", "problem.points.counts=[4, 4]"}).exit, 0);
  folder.write("quick.toml", "");
  const Output report = run(folder, {"report", "results/mine"});
  EXPECT_EQ(report.exit, 0) << report.err;
  EXPECT_FALSE(contains(report.err, "no pictures")) << report.err;
  EXPECT_TRUE(contains(read_file(folder.path() / "results/mine/report.html"), "<svg class=\"plate"));
}

}  // namespace
}  // namespace nodal::program
