// SPDX-License-Identifier: GPL-3.0-or-later
// Stored trials for the tools of other benchmarks, as a user writes them.
#include <gtest/gtest.h>

#include <exchange/format.h>

#include "../exchange/read_back.h"
#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

namespace read_back = exchange::read_back;

class ExportedTrials : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("quick.toml", kQuickStudy);
    ASSERT_EQ(run(folder_, {"compare", "quick.toml", "--out", "store"}).exit, 0);
  }
  Folder folder_;
};

// Four real trials, of two optimizers on a plate of nine nodes.
TEST_F(ExportedTrials, KeepTheRulesOfTheirReaders) {
  for (const exchange::Format& format : exchange::formats()) {
    const std::string name(format.name);
    const Output output = run(folder_, {"export", "store", "--format", name, "--out", "new/" + name});
    ASSERT_EQ(output.exit, 0) << output.err;
    EXPECT_TRUE(contains(output.out, "of 2 algorithms are in 'new/" + name + "'")) << output.out;
    const auto read = name == "coco" ? read_back::read_coco : read_back::read_ioh;
    const read_back::Read back = read(folder_.path() / "new" / name);
    EXPECT_EQ(back.faults, std::vector<std::string>());
    ASSERT_EQ(back.sets.size(), 2u);
    for (const read_back::DataSet& set : back.sets) {
      ASSERT_EQ(set.runs.size(), 2u);
      EXPECT_EQ(set.runs[0].evaluations, 301);
    }
  }
}

TEST_F(ExportedTrials, OverwriteNothing) {
  std::filesystem::create_directory(folder_.path() / "mine");
  folder_.write("mine/notes", "mine\n");
  const Output output = run(folder_, {"export", "store", "--format", "coco", "--out", "mine"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: --out: 'mine' is not empty; give a new folder\n");
  EXPECT_EQ(run(folder_, {"export", "store", "--format", "coco", "--out", "quick.toml"}).exit, 2);
  EXPECT_EQ(run(folder_, {"export", "store", "--format", "coco", "--out", "store"}).exit, 2);
  EXPECT_EQ(read_file(folder_.path() / "quick.toml"), kQuickStudy);
}

TEST_F(ExportedTrials, AreAskedForInAFormatThatIsThere) {
  const Output output = run(folder_, {"export", "store", "--format", "csv", "--out", "new"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(contains(output.err, "csv not in {coco,ioh}")) << output.err;
  EXPECT_EQ(run(folder_, {"export", "nothing", "--format", "coco", "--out", "new"}).exit, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "new"));
}

TEST(Init, WritesAStudyThatIsExplainedAndCompared) {
  const Folder folder;
  EXPECT_EQ(run(folder, {"init", "new.toml", "--optimizer", "annealing", "--optimizer", "random-search"}).exit, 0);
  EXPECT_EQ(run(folder, {"explain", "new.toml"}).exit, 0);
  const Output output = run(folder, {"compare", "new.toml", "--repeats", "1", "--evaluations", "50"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "annealing (baseline)")) << output.out;
}

TEST(Init, OverwritesNoFile) {
  const Folder folder;
  folder.write("mine.toml", "mine\n");
  const Output output = run(folder, {"init", "mine.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: 'mine.toml' is there already, and is left as it is; give a new name\n");
  EXPECT_EQ(read_file(folder.path() / "mine.toml"), "mine\n");
  EXPECT_EQ(run(folder, {"init", "there/new.toml"}).exit, 2);
  EXPECT_TRUE(contains(run(folder, {"init", "--problem", "sphere"}).out, "\nkind = \"sphere\""));
}

TEST(Schema, IsOneTextOfJson) {
  const Folder folder;
  const Output output = run(folder, {"schema"});
  EXPECT_EQ(output.exit, 0);
  const Value schema = parse_json(output.out, "schema");
  EXPECT_EQ(schema.at("$schema").text(), "http://json-schema.org/draft-07/schema#");
  EXPECT_TRUE(schema.at("definitions").find("optimizer-annealing"));
}

}  // namespace
}  // namespace nodal::program
