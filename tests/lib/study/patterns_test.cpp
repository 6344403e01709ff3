// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../../support/messages.h"
#include "../toy_study.h"

namespace nodal {
namespace {

Study race(const std::string& optimizers, const std::string& kind = "bowl") {
  return toy::study("[problem]\nkind = \"" + kind + "\"\n" + optimizers);
}

std::vector<std::string> labels(const Study& study) {
  std::vector<std::string> all;
  for (const StudyOptimizer& optimizer : study.optimizers) all.push_back(optimizer.label);
  return all;
}

TEST(Patterns, MeanEveryMethodOfThatName) {
  EXPECT_EQ(labels(race("[[optimizer]]\nuse = \"thr*\"\n")),
            (std::vector<std::string>{"throwing", "throwing-a-number"}));
  EXPECT_EQ(labels(race("[[optimizer]]\nuse = \"?alving\"\n")), (std::vector<std::string>{"halving"}));
}

TEST(Patterns, LeaveOutWhatHasAnEntryOfItsOwn) {
  const Study study = race("[[optimizer]]\nuse = \"thr*\"\n[[optimizer]]\nuse = \"throwing\"\nlabel = \"mine\"\n");
  EXPECT_EQ(labels(study), (std::vector<std::string>{"throwing-a-number", "mine"}));
}

// What is asked for by name is refused; what a pattern happens to mean is left out, and said.
TEST(Patterns, LeaveOutWhatAProblemCantServe) {
  const Study study = race("[[optimizer]]\nuse = \"[nw]*\"\n", "bare");
  EXPECT_EQ(labels(study), (std::vector<std::string>{"wanderer"}));
  ASSERT_EQ(study.left_out.size(), 3u);
  EXPECT_EQ(study.left_out.back().use + ": " + study.left_out.back().reason.substr(0, 11), "nlopt-*: needs NLopt");
  EXPECT_EQ(study.left_out[0].label, "newton");
  EXPECT_EQ(study.left_out[0].reason, "needs gradient and residuals, which problem 'bare' can't give");
}

TEST(Patterns, LeaveOutWhatLooksAtNoStartUnderMultiStart) {
  const Study study = race("[[optimizer]]\nuse = \"[hw]a*\"\nmulti_start = true\n");
  EXPECT_EQ(labels(study), (std::vector<std::string>{"halving", "hanging"}));
  ASSERT_EQ(study.left_out.size(), 2u);
  EXPECT_NE(study.left_out[0].reason.find("looks at no start"), std::string::npos);
}

TEST(Patterns, LookAtTheProblemsAskedForOnly) {
  StudyOverrides overrides;
  overrides.only_problems = {"bowl"};
  const Study study = toy::study(
      "[[problem]]\nkind = \"bowl\"\n[[problem]]\nkind = \"bare\"\n[[optimizer]]\nuse = \"newt*\"\n", overrides);
  EXPECT_EQ(labels(study), (std::vector<std::string>{"newton"}));
}

TEST(Patterns, OfAbsentMethodsSayWhy) {
  const Study study = race("[[optimizer]]\nuse = \"nlopt-*\"\n[[optimizer]]\nuse = \"halving\"\n");
  EXPECT_EQ(labels(study), (std::vector<std::string>{"halving"}));
  ASSERT_EQ(study.left_out.size(), 1u);
  EXPECT_NE(study.left_out[0].reason.find("needs NLopt"), std::string::npos);
}

TEST(Patterns, TakeOptionsAndRanges) {
  const Study study = race("[[optimizer]]\nuse = \"halv*\"\noptions = { factor = { grid = [0.25, 0.5] } }\n");
  EXPECT_EQ(labels(study), (std::vector<std::string>{"halving factor=0.25", "halving factor=0.5"}));
}

TEST(Patterns, HaveNoLabelAndMeanSomething) {
  const auto refusal = [](const std::string& text) { return toy::message_of([&] { (void)race(text); }); };
  EXPECT_NE(refusal("[[optimizer]]\nuse = \"wa*\"\nlabel = \"x\"\n").find("s.toml:5: 'label' is of one"),
            std::string::npos);
  EXPECT_NE(refusal("[[optimizer]]\nuse = \"wa*\"\nbaseline = true\n").find("'baseline' is of one"), std::string::npos);
  EXPECT_NE(refusal("[[optimizer]]\nuse = \"q*\"\n").find("s.toml:4: no optimizer's name is like 'q*'"),
            std::string::npos);
}

}  // namespace
}  // namespace nodal
