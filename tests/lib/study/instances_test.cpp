// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/trial.h>

#include "../../support/messages.h"
#include "../toy_study.h"
#include "refusals.h"

namespace nodal {
namespace {

using toy::refusal_after_problem;

TEST(Instances, AGridMakesAProblemOfEachValue) {
  const Study study = toy::study("[problem]\nkind = \"bowl\"\nsize = { grid = [2, 4, 6] }\n");
  ASSERT_EQ(study.problems.size(), 3u);
  EXPECT_EQ(study.problems[0].label, "bowl size=2");
  EXPECT_EQ(study.problems[2].label, "bowl size=6");
  EXPECT_EQ(study.problems[2].problem->space().size(), 6u);
}

TEST(Instances, AGridMayHaveOneValue) {
  const Study study = toy::study("[problem]\nkind = \"bowl\"\nsize = { grid = [4] }\n");
  ASSERT_EQ(study.problems.size(), 1u);
  EXPECT_EQ(study.problems[0].options.integer("size"), 4);
  EXPECT_EQ(study.problems[0].label, "bowl size=4");
}

TEST(Instances, RangesCombineAndTheLastVariesFastest) {
  const Study study = toy::study(
      "[problem]\nkind = \"bowl\"\nlabel = \"B\"\nsize = { count = 2, from = 4 }\neven = { grid = [false] }\n"
      "[[optimizer]]\nuse = \"halving\"\noptions = { factor = { grid = [0.25, 0.5] } }\n");
  ASSERT_EQ(study.problems.size(), 2u);
  EXPECT_EQ(study.problems[0].label, "B size=4 even=false");
  EXPECT_EQ(study.problems[1].label, "B size=5 even=false");
  ASSERT_EQ(study.optimizers.size(), 2u);
  EXPECT_EQ(study.optimizers[0].label, "halving factor=0.25");
  EXPECT_EQ(study.optimizers[1].options.number("factor"), 0.5);
}

// One plate of a range is the plate itself: its trials have the keys that it would have alone, but for its label.
TEST(Instances, AreWhatTheyWouldBeAlone) {
  const Study range = toy::study(
      "[budget]\nevaluations = 9\n[problem]\nkind = \"bowl\"\nsize = { grid = [2, 4] }\n"
      "[[optimizer]]\nuse = \"halving\"\n");
  const Study alone = toy::study(
      "[budget]\nevaluations = 9\n[problem]\nkind = \"bowl\"\nlabel = \"bowl size=4\"\n"
      "size = 4\n[[optimizer]]\nuse = \"halving\"\n");
  EXPECT_EQ(trial_key(range, {1, 0, 0}), trial_key(alone, {0, 0, 0}));
}

TEST(Instances, WhatIsNoRangeIsRefused) {
  EXPECT_NE(refusal_after_problem("size = { grid = [] }\n").find("s.toml:3: 'grid' must list"), std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { grid = 3 }\n").find("'grid' must list"), std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { grid = [1], step = 3 }\n").find("'step' stands beside a range"),
            std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { count = 0 }\n").find("whole number from 1 to"), std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { count = 1e3 }\n").find("whole number"), std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { count = 100000000 }\n").find("too long"), std::string::npos);
  EXPECT_NE(refusal_after_problem("label = { grid = [\"a\"] }\n").find("can't be a range"), std::string::npos);
  EXPECT_NE(
      refusal_after_problem("best_known = { quality = { grid = [1, 2] }, origin = \"x\" }\n").find("of one problem"),
      std::string::npos);
  EXPECT_NE(refusal_after_problem("size = { count = 2 }\nbest_known = { quality = 1, origin = \"x\" }\n")
                .find("ranges beside it"),
            std::string::npos);
  // No ranges: keys that nobody knows.
  EXPECT_NE(refusal_after_problem("count = 3\n").find("s.toml:3: unknown"), std::string::npos)
      << refusal_after_problem("count = 3\n");
  EXPECT_NE(refusal_after_problem("grid = [1]\n").find("s.toml:3: unknown"), std::string::npos)
      << refusal_after_problem("grid = [1]\n");
  EXPECT_NE(
      refusal_after_problem("size = { count = 100 }\neven = { count = 100 }\n").find("more than 1000 combinations"),
      std::string::npos);
}

// A value of a range is checked as any other, and where it stands.
TEST(Instances, OfEqualValuesAreRefusedForWhatTheyAre) {
  EXPECT_NE(refusal_after_problem("size = { grid = [2, 2] }\n")
                .find("both of one entry: values of a range that are the same"),
            std::string::npos);
}

TEST(Instances, ValuesOfARangeAreChecked) {
  EXPECT_NE(refusal_after_problem("size = { grid = [2,\n 400] }\n").find("s.toml:4: "), std::string::npos)
      << refusal_after_problem("size = { grid = [2,\n 400] }\n");
}

TEST(Instances, OnlySomeProblemsMayBeAskedFor) {
  StudyOverrides overrides;
  overrides.only_problems = {"bowl size=4"};
  constexpr const char* text =
      "[budget]\nevaluations = 9\n[problem]\nkind = \"bowl\"\nsize = { grid = [2, 4] }\n[[optimizer]]\nuse = "
      "\"halving\"\n";
  const Study study = toy::study(text, overrides);
  EXPECT_TRUE(study.problems[0].skipped);
  for (const Trial& trial : all_trials(study)) EXPECT_EQ(trial.problem, 1u);
  overrides.only_problems = {"bowl"};
  EXPECT_NE(toy::message_of([&] { (void)toy::study(text, overrides); }).find("--problem: no problem"),
            std::string::npos);
}

}  // namespace
}  // namespace nodal
