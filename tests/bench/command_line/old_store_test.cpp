// SPDX-License-Identifier: GPL-3.0-or-later
// Results outlive the program that made them: tests/data/store-0.1.0 was written by version 0.1.0 for the study beside
// it.
#include <gtest/gtest.h>

#include <nodal/store.h>

#include "../../support/count.h"
#include "program.h"

namespace nodal::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrialsFile = "trials/host-26413-1795765673044.jsonl";

const fs::path& original() {
  static const fs::path path = fs::path(NODAL_TEST_DATA) / "store-0.1.0";
  return path;
}

using toy::count;

TEST(StoreOfVersion010, IsRead) {
  const Store store = Store::open_existing(original());
  EXPECT_TRUE(store.warnings().empty());
  ASSERT_EQ(store.records().size(), 8u);
  for (const TrialRecord& record : store.records()) {
    EXPECT_EQ(record.attempt, 1);
    EXPECT_FALSE(record.conditions);
    EXPECT_EQ(contamination(record), "");
    ASSERT_TRUE(record.best);
  }
  EXPECT_EQ(store.records()[0].optimizer, "annealing");
  EXPECT_EQ(store.records()[0].best->summary.quality, 2.699060307784598);
  EXPECT_EQ(store.records()[0].trace.size(), 12u);
}

TEST(StoreOfVersion010, IsReported) {
  const Folder folder;
  fs::copy(original(), folder.path() / "old", fs::copy_options::recursive);
  const Output output = run(folder, {"report", "old"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_NE(output.out.find("sphere: quality at the start 5.610"), std::string::npos) << output.out;
  EXPECT_NE(output.out.find("0.7752"), std::string::npos) << output.out;  // random search on the sphere, the median
  EXPECT_NE(output.out.find("elastic: G at the start 40.04"), std::string::npos) << output.out;
  EXPECT_TRUE(fs::exists(folder.path() / "old" / "report.html"));
}

// The sphere's trials are named as they were; an elastic problem may have got options since, and is another problem
// then.
TEST(StoreOfVersion010, IsExtended) {
  const Folder folder;
  fs::copy(original(), folder.path() / "old", fs::copy_options::recursive);
  fs::copy_file(original() / "kept.toml", folder.path() / "kept.toml");
  const std::string before = read_file(folder.path() / "old" / kTrialsFile);
  const Output output = run(folder, {"compare", "kept.toml", "--out", "old", "--repeats", "3"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_NE(output.err.find("of 12 trials are stored already"), std::string::npos) << output.err;
  EXPECT_NE(output.err.find("holds results of another build (revision 9091477158fe-dirty; the present one is "),
            std::string::npos)
      << output.err;
  EXPECT_EQ(read_file(folder.path() / "old" / kTrialsFile), before);
  const Store store = Store::open_existing(folder.path() / "old");
  std::size_t old = 0, on_sphere = 0;
  for (const TrialRecord& record : store.records()) {
    old += !record.conditions;
    on_sphere += record.problem == "sphere";
  }
  EXPECT_EQ(old, 8u);
  EXPECT_EQ(on_sphere, 6u);
  EXPECT_EQ(count(read_file(folder.path() / "old" / "manifest.json"), "\"began\""), 2u);
}

}  // namespace
}  // namespace nodal::program
