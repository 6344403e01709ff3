// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/trial.h>

#include "../../support/messages.h"
#include "../toy_study.h"

namespace nodal {
namespace {

constexpr const char* kTwo =
    "[[problem]]\nkind = \"bowl\"\nlabel = \"v1.0 = x\"\n[[problem]]\nkind = \"bowl\"\nlabel = \"b\"\n"
    "[[optimizer]]\nuse = \"halving\"\n[[optimizer]]\nuse = \"wanderer\"\n";

Study with(std::vector<std::string> settings, std::string_view text = kTwo) {
  StudyOverrides overrides;
  overrides.set = std::move(settings);
  return toy::study(text, overrides);
}

std::string refusal_of_setting(const std::string& setting) {
  return toy::message_of([&] { (void)with({setting}); });
}

TEST(Settings, AreValuesOfAnyKey) {
  const Study study = with({"study.seed=9", "study.name=other", "budget.seconds=0.5", "problem.size=4"});
  EXPECT_EQ(study.seed, 9u);
  EXPECT_EQ(study.name, "other");
  EXPECT_EQ(study.budget.seconds, 0.5);
  EXPECT_EQ(study.problems[0].options.integer("size"), 4);
  EXPECT_EQ(study.problems[1].options.integer("size"), 4);
  EXPECT_EQ(study.settings.size(), 4u);
}

TEST(Settings, IncludeNothing) {
  for (const char* setting : {"include=x.toml", "include=[]", "include.x=3", "include[a].x=3"})
    EXPECT_NE(refusal_of_setting(setting).find("give include in the study"), std::string::npos) << setting;
}

TEST(Settings, MayBeOfOneEntry) {
  const Study study = with(
      {"problem[v1.0 = x].size=2", "optimizer[halving].options.factor=0.125", "optimizer[wanderer].label=\"a = b\""});
  EXPECT_EQ(study.problems[0].options.integer("size"), 2);
  EXPECT_EQ(study.problems[1].options.integer("size"), 3);
  EXPECT_EQ(study.optimizers[0].options.number("factor"), 0.125);
  EXPECT_EQ(study.optimizers[1].label, "a = b");
}

TEST(Settings, TheLastOneCounts) { EXPECT_EQ(with({"study.seed=1", "study.seed=2"}).seed, 2u); }

TEST(Settings, MayBeRanges) {
  const Study study = with({"problem.size={ grid = [2, 4] }"}, "[problem]\nkind = \"bowl\"\n");
  ASSERT_EQ(study.problems.size(), 2u);
  EXPECT_EQ(study.problems[1].label, "bowl size=4");
}

TEST(Settings, HaveAllThatTheCommandLineChanged) {
  StudyOverrides overrides;
  overrides.set = {"problem.size=4"};
  overrides.seconds = 0.25;
  overrides.evaluations = 70;
  overrides.seed = 9;
  overrides.repeats = 2;
  const Study changed = toy::study(kTwo, overrides);
  const Study again = with(changed.settings);
  const std::vector<Trial> trials = all_trials(changed);
  ASSERT_EQ(all_trials(again).size(), trials.size());
  for (const Trial& trial : trials) EXPECT_EQ(trial_key(changed, trial), trial_key(again, trial));
}

// A best known quality is of the problem as it stands in the file.
TEST(Settings, OfAProblemForgetItsBestKnownQuality) {
  constexpr const char* known = "[problem]\nkind = \"bare\"\nbest_known = { quality = 3, origin = \"file\" }\n";
  EXPECT_EQ(with({"problem.label=x"}, known).problems[0].best_known->origin, "file");
  constexpr const char* sized =
      "[problem]\nkind = \"bowl\"\nsize = 2\nbest_known = { quality = 3, origin = \"file\" }\n";
  EXPECT_EQ(with({}, sized).problems[0].best_known->origin, "file");
  EXPECT_NE(with({"problem.size=4"}, sized).problems[0].best_known->origin, "file");
  EXPECT_EQ(with({"problem.best_known.quality=5", "problem.size=4"}, sized).problems[0].best_known->quality, 5.0);
}

TEST(Settings, AreOneKeyAndNumbersAreNumbers) {
  EXPECT_NE(refusal_of_setting("study.seed=3\nrepeats=1").find("--set"), std::string::npos);
  for (const char* number : {".5", "1.", "007", "-.5"})
    EXPECT_NE(refusal_of_setting(std::string("study.name=") + number).find("begin and end with a digit"),
              std::string::npos)
        << number;
}

TEST(Settings, WrongOnesAreNamed) {
  for (const char* wrong : {"", "study", "=3", "study=3", "study.=3", ".seed=3", "study.seed", "problem[b.size=3"})
    EXPECT_EQ(refusal_of_setting(wrong).rfind(std::string("--set ") + wrong + ": ", 0), 0u)
        << refusal_of_setting(wrong);
  EXPECT_NE(refusal_of_setting("study.name=a b").find("need quotes"), std::string::npos);
  EXPECT_NE(refusal_of_setting("problem[c].size=3").find("labelled 'c'"), std::string::npos);
  EXPECT_NE(refusal_of_setting("problem.size.x=3").find("--set problem.size.x=3"), std::string::npos);
  EXPECT_NE(refusal_of_setting("problem.sise=3").find("--set problem.sise=3"), std::string::npos);
  EXPECT_NE(refusal_of_setting("optimiser.use=x").find("unknown table"), std::string::npos);
}

TEST(Settings, GoNoFurtherThanTables) {
  EXPECT_NE(toy::message_of([] {
              (void)with({"problem.size=2", "problem.size.x=3"});
            }).find("has no keys"),
            std::string::npos);
}

}  // namespace
}  // namespace nodal
