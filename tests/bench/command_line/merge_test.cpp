// SPDX-License-Identifier: GPL-3.0-or-later
// Stores that become one, and studies that were set or joined when they ran.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

#include <nodal/merge.h>
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

Output compare_into(const Folder& folder, const char* store, std::vector<std::string> more) {
  std::vector<std::string> arguments = {"compare", "quick.toml", "--out", store};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Output output = run(folder, arguments);
  EXPECT_EQ(output.exit, 0) << output.err;
  return output;
}

// In either order; nothing is written.
void expect_refused(const Folder& folder, const std::string& message) {
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("b", "a")})
    for (const char* command : {"merge", "report"}) {
      const Output refused = run(folder, {command, first, second, "--out", "c"});
      EXPECT_EQ(refused.exit, 2);
      EXPECT_TRUE(contains(refused.err, message)) << refused.err;
      EXPECT_FALSE(std::filesystem::exists(folder.path() / "c" / "manifest.json"));
    }
}

TEST(Merge, RefusesOtherBudgetsStartsAndOptimizers) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  compare_into(folder, "a", {"--evaluations", "100"});
  compare_into(folder, "b", {"--evaluations", "200"});
  expect_refused(folder, "raced problem 'elastic' under other terms (");
  std::filesystem::remove_all(folder.path() / "b");
  compare_into(folder, "b", {"--evaluations", "100", "--set", "study.starts=sampled"});
  expect_refused(folder, "starts = \"sampled\"");
  std::filesystem::remove_all(folder.path() / "b");
  compare_into(folder, "b", {"--evaluations", "100", "--set", "optimizer[annealing].options.step=0.01"});
  expect_refused(folder, "mean different optimizers by the label 'annealing' (step: 0.");
}

TEST(Merge, TellsOfOtherSeedsAndVerifiesWhatItsStudyAsksFor) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  compare_into(folder, "a", {"--evaluations", "100"});
  compare_into(folder, "b", {"--evaluations", "100", "--seed", "77"});
  const Output merged = run(folder, {"merge", "a", "b", "--out", "c"});
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_TRUE(contains(merged.err, "'b' is of another study than 'a': set by its command line: ")) << merged.err;
  EXPECT_TRUE(contains(merged.err, "study.seed=77")) << merged.err;
  EXPECT_TRUE(contains(merged.err, "its seed is another")) << merged.err;
  const Output verified = run(folder, {"verify", "c"});
  EXPECT_EQ(verified.exit, 0) << verified.err;
  EXPECT_TRUE(contains(verified.out, "4 of 4 trials")) << verified.out;
  EXPECT_TRUE(contains(verified.out, "4 other stored trials can't be checked")) << verified.out;
  const Output reported = run(folder, {"report", "a", "b", "--out", "d"});
  EXPECT_TRUE(contains(reported.err, "its seed is another")) << reported.err;
}

// Each text stands by itself: together they are no TOML.
TEST(Merge, LeavesNothingWhereItFails) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  compare_into(folder, "a", {"--evaluations", "100"});
  std::vector<Store> stores;
  stores.push_back(Store::open_existing(folder.path() / "a"));
  MergedStores merged = merge_stores(stores);
  const Value whole = merged.manifest;
  merged.manifest.set("runs", std::nan(""));  // never reaches JSON
  const std::filesystem::path there = folder.path() / "there", made = folder.path() / "made";
  std::filesystem::create_directory(there);
  EXPECT_ANY_THROW(write_merged(stores, merged, there));
  EXPECT_TRUE(std::filesystem::is_empty(there));
  EXPECT_ANY_THROW(write_merged(stores, merged, made));
  EXPECT_FALSE(std::filesystem::exists(made));
  merged.manifest = whole;
  write_merged(stores, merged, there);
  EXPECT_EQ(Store::open_existing(there).records().size(), 4u);
}

TEST(Merge, KeepsTextsApart) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  compare_into(folder, "a", {"--evaluations", "100", "--only", "annealing"});
  folder.write("quick.toml", "# Once more.\n" + std::string(kQuickStudy));
  compare_into(folder, "b", {"--evaluations", "100", "--only", "random-search"});
  const Output merged = run(folder, {"merge", "a", "b", "--out", "c"});
  EXPECT_TRUE(contains(merged.err, "'b' is of another study than 'a': another text")) << merged.err;
  const Store store = Store::open_existing(folder.path() / "c");
  EXPECT_EQ(store.manifest().at("study").at("text").text(), kQuickStudy);
  EXPECT_EQ(store.manifest().at("other_studies").list().size(), 1u);
  const Output verified = run(folder, {"verify", "c"});
  EXPECT_EQ(verified.exit, 0) << verified.err;
  EXPECT_TRUE(contains(verified.out, "4 of 4 trials")) << verified.out;
  EXPECT_TRUE(contains(run(folder, {"report", "c"}).out, "evaluations"));
  EXPECT_TRUE(contains(read_file(folder.path() / "c" / "report.html"), "Once more."));
  // What is merged can be merged.
  EXPECT_EQ(run(folder, {"merge", "c", "a", "--out", "e"}).exit, 0);
  EXPECT_EQ(Store::open_existing(folder.path() / "e").manifest().at("other_studies").list().size(), 1u);
}

TEST(Merge, ShowsWhatAnyStoreAsksForByItsLatestAttempt) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  compare_into(folder, "a", {"--evaluations", "100"});
  std::filesystem::copy(folder.path() / "a", folder.path() / "b", std::filesystem::copy_options::recursive);
  compare_into(folder, "b", {"--evaluations", "100", "--fresh"});
  compare_into(folder, "a", {"--evaluations", "100", "--repeats", "1"});
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("b", "a")}) {
    const Output merged = run(folder, {"merge", first, second, "--out", std::string("m") + first});
    EXPECT_FALSE(contains(merged.err, "not shown")) << merged.err;
    const Store store = Store::open_existing(folder.path() / (std::string("m") + first));
    EXPECT_EQ(store.records().size(), 4u);
    for (const TrialRecord& record : store.records()) EXPECT_EQ(record.attempt, 2);
    EXPECT_EQ(store.manifest().at("keys").list().size(), 4u);
  }
  // What nobody asks for is said on the terminal, too.
  EXPECT_TRUE(contains(run(folder, {"report", "a"}).err, "2 stored trials in 'a' are not shown"));
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
