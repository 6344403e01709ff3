// SPDX-License-Identifier: GPL-3.0-or-later
// A study dealt out to several processes that share a store.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include <nodal/store.h>
#include <nodal/verify.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// What doesn't hang on the clock, by key.
std::map<std::string, std::string> outcomes(const std::filesystem::path& directory) {
  std::map<std::string, std::string> found;
  const Store store = Store::open_existing(directory);
  for (const TrialRecord& record : store.records()) found[record.key] = to_json_line(untimed(record));
  return found;
}

TEST(Shards, AtOnceMakeTheTrialsOfOneProcess) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "whole"}).exit, 0);
  std::vector<std::unique_ptr<Folder>> outputs;
  std::vector<std::unique_ptr<Started>> started;
  const std::string study = (folder.path() / "quick.toml").string(), out = (folder.path() / "shared").string();
  for (const char* share : {"1/4", "2/4", "3/4", "4/4"}) {
    outputs.push_back(std::make_unique<Folder>());
    started.push_back(std::make_unique<Started>(
        *outputs.back(), std::vector<std::string>{"compare", study, "--out", out, "--shard", share}));
  }
  for (const auto& one : started) {
    const Output output = one->wait();
    EXPECT_EQ(output.exit, 0) << output.err;
    EXPECT_TRUE(contains(output.out, "1 of 1 trials of this share ran")) << output.out;
    EXPECT_FALSE(contains(output.err, "another comparison")) << output.err;
  }
  EXPECT_TRUE(outcomes(folder.path() / "whole") == outcomes(folder.path() / "shared"));
  EXPECT_EQ(run(folder, {"report", "shared"}).exit, 0);
}

TEST(Trials, ArePrintedAndRunByTheirKeys) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output all = run(folder, {"trials", "quick.toml"});
  EXPECT_EQ(all.exit, 0);
  ASSERT_EQ(std::count(all.out.begin(), all.out.end(), '\n'), 4);
  EXPECT_TRUE(contains(all.out, "\telastic\trandom-search\t1\n")) << all.out;
  folder.write("list", all.out.substr(0, all.out.find('\n') + 1));
  EXPECT_TRUE(contains(run(folder, {"compare", "quick.toml", "--trials", "list"}).out, "1 of 1 trials"));
  EXPECT_EQ(Store::open_existing(folder.path() / "results" / "quick").records().size(), 1u);
  const Output wrong = run(folder, {"compare", "quick.toml", "--trials", "quick.toml"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(contains(wrong.err, "quick.toml:1: '[study]' is the key of no trial")) << wrong.err;
}

}  // namespace
}  // namespace nodal::program
