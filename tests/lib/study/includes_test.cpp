// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../../support/messages.h"
#include "../../support/temporary_directory.h"
#include "../toy_study.h"

namespace nodal {
namespace {

class Includes : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text;
  }
  [[nodiscard]] Study read(const StudyOverrides& overrides = {}) const {
    return read_study(folder_.path() / "study.toml", toy::registry(), overrides);
  }
  [[nodiscard]] std::string refusal() const {
    return toy::message_of([&] { (void)read(); });
  }

 private:
  toy::TemporaryDirectory folder_;
};

TEST_F(Includes, AStudyHasTheLastWord) {
  write("common.toml",
        "[study]\nseed = 7\nrepeats = 4\n[budget]\nseconds = 2\n[problem]\nkind = \"bowl\"\nsize = 2\n"
        "[[optimizer]]\nuse = \"halving\"\noptions = { factor = 0.25 }\n");
  write("study.toml",
        "include = \"common.toml\"\n[study]\nrepeats = 5\n[problem]\nsize = 6\n"
        "[[optimizer]]\nuse = \"wanderer\"\n");
  const Study study = read();
  EXPECT_EQ(study.seed, 7u);
  EXPECT_EQ(study.repeats, 5);
  EXPECT_EQ(study.budget.seconds, 2.0);
  EXPECT_EQ(study.name, "study");
  ASSERT_EQ(study.problems.size(), 1u);
  EXPECT_EQ(study.problems[0].options.integer("size"), 6);
  ASSERT_EQ(study.optimizers.size(), 2u);
  EXPECT_EQ(study.optimizers[0].options.number("factor"), 0.25);
  EXPECT_EQ(study.optimizers[1].use, "wanderer");
  ASSERT_EQ(study.included.size(), 1u);
  EXPECT_NE(study.included[0].text.find("factor = 0.25"), std::string::npos);
  EXPECT_EQ(study.text.substr(0, 7), "include");
}

// Twelve files, sixteen million reads.
TEST_F(Includes, AreNotTooMany) {
  for (int i = 1; i <= 12; ++i) {
    const std::string next = "'" + std::to_string(i + 1) + ".toml'";
    write(std::to_string(i) + ".toml", "include = [" + next + ", " + next + ", " + next + ", " + next + "]\n");
  }
  write("13.toml", "");
  write("study.toml", "include = '1.toml'\n[problem]\nkind = \"bowl\"\n");
  EXPECT_NE(refusal().find(".toml:1: "), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("is one file too many: a study includes at most 100"), std::string::npos) << refusal();
  std::string names;
  for (int i = 0; i < 100; ++i) names += "'13.toml', ";
  write("study.toml", "include = [" + names + "]\n[problem]\nkind = \"bowl\"\n");
  EXPECT_EQ(read().included.size(), 100u);
}

TEST_F(Includes, OfAnotherProblemHaveNotItsBestKnownQuality) {
  write("common.toml", "[problem]\nkind = \"bare\"\nbest_known = { quality = 3, origin = \"file\" }\n");
  write("study.toml", "include = \"common.toml\"\n[problem]\nlabel = \"x\"\n");
  EXPECT_TRUE(read().problems[0].best_known);
  write("study.toml", "include = \"common.toml\"\n[problem]\nkind = \"bare\"\n");
  EXPECT_FALSE(read().problems[0].best_known);
}

TEST_F(Includes, LieBesideTheFileThatSaysThem) {
  write("parts/more/budget.toml", "[budget]\nevaluations = 9\n");
  write("parts/common.toml", "include = [\"more/budget.toml\"]\n[problem]\nkind = \"bowl\"\n");
  write("study.toml", "include = [\"parts/common.toml\"]\n");
  EXPECT_EQ(read().budget.evaluations, 9);
}

TEST_F(Includes, OfSeveralTheLaterWins) {
  write("a.toml", "[study]\nseed = 1\n[[problem]]\nkind = \"bowl\"\nlabel = \"a\"\n");
  write("b.toml", "[study]\nseed = 2\n[[problem]]\nkind = \"bowl\"\nlabel = \"b\"\n");
  write("study.toml", "include = [\"a.toml\", \"b.toml\"]\n");
  const Study study = read();
  EXPECT_EQ(study.seed, 2u);
  ASSERT_EQ(study.problems.size(), 2u);
  EXPECT_EQ(study.problems[1].label, "b");
}

TEST_F(Includes, WhatIsWrongInOneIsSaidOfIt) {
  write("common.toml", "[problem]\nkind = \"bowl\"\nsise = 2\n");
  write("study.toml", "include = \"common.toml\"\n");
  EXPECT_NE(refusal().find("common.toml:3: "), std::string::npos) << refusal();
}

TEST_F(Includes, OneThatIsNotThereIsRefusedWhereItIsAskedFor) {
  write("study.toml", "include = \"none.toml\"\n[problem]\nkind = \"bowl\"\n");
  EXPECT_NE(refusal().find("study.toml:1: "), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("none.toml"), std::string::npos);
}

TEST_F(Includes, ACircleIsRefused) {
  write("a.toml", "include = \"study.toml\"\n");
  write("study.toml", "include = \"a.toml\"\n[problem]\nkind = \"bowl\"\n");
  EXPECT_NE(refusal().find("includes itself"), std::string::npos) << refusal();
}

TEST_F(Includes, OtherTypesAreRefused) {
  write("study.toml", "include = 7\n[problem]\nkind = \"bowl\"\n");
  EXPECT_NE(refusal().find("study.toml:1: "), std::string::npos) << refusal();
}

}  // namespace
}  // namespace nodal
