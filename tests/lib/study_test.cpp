// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/study.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <new>

#include "../support/messages.h"
#include "../support/temporary_directory.h"
#include "study/refusals.h"
#include "toy_study.h"

namespace nodal {
namespace {

using toy::refusal;
using toy::refusal_after_problem;
using toy::study;

constexpr const char* kWhole = R"(
[study]
name = "toys"
seed = 7
repeats = 4
starts = "sampled"

[budget]
seconds = 2
evaluations = 100
target_gap = 1e-3

[problem]
kind = "bowl"
size = 2

[[optimizer]]
use = "halving"
baseline = true

[[optimizer]]
use = "halving"
label = "again and again"
multi_start = true
options = { factor = 0.25 }

[[optimizer]]
use = "wanderer"
)";

TEST(StudyLabels, StandInOneLine) {
  for (const char* label : {"a\\nb", "a\\tb", "a\\u001bb"}) {
    const std::string text = std::string("label = \"") + label + "\"\n";
    for (const std::string& message :
         {refusal_after_problem(text), refusal_after_problem("[[optimizer]]\nuse = \"halving\"\n" + text)})
      EXPECT_NE(message.find("no part of a line: '" + std::string(label)), std::string::npos) << message;
  }
}

TEST(Study, HoldsWhatTheFileSays) {
  const Study s = study(kWhole);
  EXPECT_EQ(s.name, "toys");
  EXPECT_EQ(s.seed, 7u);
  EXPECT_EQ(s.repeats, 4);
  EXPECT_EQ(s.starts, Starts::sampled);
  EXPECT_EQ(s.budget.seconds, 2.0);
  EXPECT_EQ(s.budget.evaluations, 100);
  EXPECT_EQ(s.budget.target_gap, 1e-3);
  EXPECT_EQ(s.text, kWhole);
  EXPECT_EQ(s.path, "s.toml");
  ASSERT_EQ(s.problems.size(), 1u);
  EXPECT_EQ(s.problems[0].label, "bowl");
  EXPECT_EQ(s.problems[0].problem->space().size(), 2u);
  EXPECT_EQ(s.problems[0].best_known->origin, "by construction");
  ASSERT_EQ(s.optimizers.size(), 3u);
  EXPECT_TRUE(s.optimizers[0].baseline);
  EXPECT_TRUE(s.optimizers[0].deterministic);
  EXPECT_EQ(s.optimizers[0].options.number("factor"), 0.5);
  EXPECT_EQ(s.optimizers[1].label, "again and again");
  EXPECT_TRUE(s.optimizers[1].multi_start);
  EXPECT_FALSE(s.optimizers[1].deterministic);
  EXPECT_EQ(s.optimizers[1].options.number("factor"), 0.25);
  EXPECT_EQ(s.optimizers[2].label, "wanderer");
  EXPECT_TRUE(s.left_out.empty());
}

TEST(Study, NeedsNothingButAProblem) {
  const Study s = study("[problem]\nkind = \"bowl\"\n");
  EXPECT_EQ(s.name, "s");
  EXPECT_EQ(s.seed, 1u);
  EXPECT_EQ(s.repeats, 15);
  EXPECT_EQ(s.starts, Starts::initial);
  EXPECT_FALSE(s.budget.seconds || s.budget.evaluations || s.budget.target_gap);
  EXPECT_TRUE(s.optimizers.empty());
}

TEST(Study, TakesSeveralProblemsWithLabels) {
  const Study s = study(R"([[problem]]
kind = "bowl"
[[problem]]
kind = "bowl"
label = "wide"
size = 9
best_known = { quality = 0.5, origin = "a guess" }
[[problem]]
kind = "bare"
)");
  ASSERT_EQ(s.problems.size(), 3u);
  EXPECT_EQ(s.problems[1].label, "wide");
  EXPECT_EQ(s.problems[1].kind, "bowl");
  EXPECT_EQ(s.problems[1].best_known->quality, 0.5);
  EXPECT_EQ(s.problems[1].best_known->origin, "a guess");
  EXPECT_EQ(s.problems[2].label, "bare");
  EXPECT_FALSE(s.problems[2].best_known.has_value());
}

TEST(Study, LetsTheCommandLineOverrideIt) {
  const Study s = study(
      kWhole, {.seconds = 0.5, .evaluations = 7, .seed = 9, .repeats = 2, .only = {"wanderer", "again and again"}});
  EXPECT_EQ(s.budget.seconds, 0.5);
  EXPECT_EQ(s.budget.evaluations, 7);
  EXPECT_EQ(s.seed, 9u);
  EXPECT_EQ(s.repeats, 2);
  ASSERT_EQ(s.optimizers.size(), 3u);  // the others stay, with what is stored of them
  EXPECT_TRUE(s.optimizers[0].skipped);
  EXPECT_FALSE(s.optimizers[1].skipped);
  EXPECT_FALSE(s.optimizers[2].skipped);
}

TEST(Study, RefusesOverridesThatMakeNoSense) {
  const auto refused = [](auto change) {
    StudyOverrides overrides;
    change(overrides);
    return refusal(kWhole, overrides);
  };
  EXPECT_EQ(refused([](StudyOverrides& o) { o.seconds = 0.0; }), "--seconds: is 0; it must be > 0");
  EXPECT_EQ(refused([](StudyOverrides& o) { o.seconds = std::nan(""); }), "--seconds: is nan; it must be > 0");
  EXPECT_EQ(refused([](StudyOverrides& o) { o.seconds = HUGE_VAL; }), "--seconds: is inf; it must be finite");
  EXPECT_EQ(refused([](StudyOverrides& o) { o.evaluations = 0; }), "--evaluations: is 0; it must be at least 1");
  EXPECT_EQ(refused([](StudyOverrides& o) { o.repeats = 0; }), "--repeats: is 0; allowed: 1 ≤ repeats ≤ 100000");
  EXPECT_EQ(refused([](StudyOverrides& o) { o.repeats = 100001; }),
            "--repeats: is 100001; allowed: 1 ≤ repeats ≤ 100000");
}

TEST(Study, RefusesUnknownTablesAndKeys) {
  EXPECT_EQ(refusal("[problem]\nkind = \"bowl\"\n[optimiser]\nuse = \"halving\"\n"),
            "s.toml:3: unknown table or key 'optimiser' in the study; did you mean 'optimizer'?");
  EXPECT_EQ(refusal("seed = 3\n[problem]\nkind = \"bowl\"\n"),
            "s.toml:1: unknown table or key 'seed' in the study; valid: 'study', 'budget', 'problem', 'optimizer'");
  EXPECT_EQ(refusal_after_problem("[study]\nrepeat = 3\n"),
            "s.toml:4: unknown key 'repeat' in [study]; did you mean 'repeats'?");
  EXPECT_EQ(refusal_after_problem("[budget]\nsecond = 3\n"),
            "s.toml:4: unknown key 'second' in [budget]; did you mean 'seconds'?");
  EXPECT_EQ(refusal_after_problem("sise = 3\n"),
            "s.toml:3: unknown key 'sise' in problem 'bowl'; did you mean 'size'?");
  EXPECT_EQ(
      refusal_after_problem("\n[[optimizer]]\nuse = \"halving\"\nfactor = 0.5\n"),
      "s.toml:6: unknown key 'factor' in [[optimizer]]; valid: 'use', 'label', 'baseline', 'multi_start', 'options'");
}

TEST(Study, RefusesOptionsThatTheOptimizerLacks) {
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\n\noptions = { facter = 0.5 }\n"),
            "s.toml:6: unknown key 'facter' in optimizer 'halving'; did you mean 'factor'?");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"wanderer\"\nlabel = \"w\"\noptions = { steps = 3 }\n"),
            "s.toml:6: unknown key 'steps' in optimizer 'w'; it has no options");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\n[optimizer.options]\nfactor = 1\n"),
            "s.toml:6: 'factor' of optimizer 'halving' is 1; allowed: 0 < factor < 1");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\noptions = 3\n"),
            "s.toml:5: optimizer 'halving' must be a table, not an integer");
}

TEST(Study, RefusesWrongTypesAndRanges) {
  EXPECT_EQ(refusal_after_problem("size = \"3\"\n"),
            "s.toml:3: 'size' of problem 'bowl' must be an integer, not a text");
  EXPECT_EQ(refusal_after_problem("size = 0\n"), "s.toml:3: 'size' of problem 'bowl' is 0; allowed: 1 ≤ size ≤ 100");
  EXPECT_EQ(refusal_after_problem("[study]\nrepeats = 2.5\n"),
            "s.toml:4: 'repeats' of [study] must be an integer, not a number");
  EXPECT_EQ(refusal_after_problem("[study]\nseed = -1\n"), "s.toml:4: 'seed' of [study] is -1; allowed: seed ≥ 0");
  EXPECT_EQ(refusal_after_problem("[study]\nrepeats = 0\n"),
            "s.toml:4: 'repeats' of [study] is 0; allowed: 1 ≤ repeats ≤ 100000");
  EXPECT_EQ(refusal_after_problem("[study]\nstarts = \"random\"\n"),
            "s.toml:4: 'starts' of [study] is 'random'; valid: 'initial', 'sampled'");
  EXPECT_EQ(refusal_after_problem("[budget]\nevaluations = 0\n"),
            "s.toml:4: 'evaluations' of [budget] is 0; allowed: evaluations ≥ 1");
  EXPECT_EQ(refusal_after_problem("[budget]\ntarget_gap = 1\n"),
            "s.toml:4: 'target_gap' of [budget] is 1; allowed: 0 < target_gap < 1");
  EXPECT_EQ(refusal_after_problem("best_known = { quality = -1, origin = \"x\" }\n"),
            "s.toml:3: 'quality' of 'best_known' of [problem] is -1; allowed: quality ≥ 0");
  EXPECT_EQ(refusal_after_problem("best_known = { quality = 1 }\n"),
            "s.toml:3: 'best_known' of [problem] lacks 'origin': who says so");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\nbaseline = 1\n"),
            "s.toml:5: 'baseline' of [[optimizer]] must be a boolean (true or false), not an integer");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nbaseline = true\n"),
            "s.toml:3: [[optimizer]] lacks 'use': which method: see nodal list optimizers");
}

TEST(Study, RefusesTablesThatAreNone) {
  EXPECT_EQ(refusal("study = 3\n"), "s.toml:1: [study] must be a table, not an integer");
  EXPECT_EQ(refusal("[[study]]\nseed = 1\n"), "s.toml:1: [study] must be a table, not a list");
  EXPECT_EQ(refusal("problem = \"bowl\"\n"), "s.toml:1: 'problem' must be a table, not a text");
  EXPECT_EQ(refusal("problem = [\n{ kind = \"bowl\" },\n3]\n"), "s.toml:3: 'problem' must be a table, not an integer");
  EXPECT_EQ(refusal("optimizer = [\"halving\"]\nproblem = { kind = \"bowl\" }\n"),
            "s.toml:1: 'optimizer' must be a table, not a text");
}

TEST(Study, RefusesToGoWithoutAProblem) {
  EXPECT_EQ(refusal(""), "s.toml: missing table [problem]; a study needs one");
  EXPECT_EQ(refusal("# nothing\n\n"), "s.toml: missing table [problem]; a study needs one");
  EXPECT_EQ(refusal("[budget]\nseconds = 1\n"), "s.toml: missing table [problem]; a study needs one");
  EXPECT_EQ(refusal("problem = []\n"), "s.toml: missing table [problem]; a study needs one");
  EXPECT_EQ(refusal("\n[problem]\n"), "s.toml:2: [problem] lacks 'kind': which problem: see nodal list problems");
}

TEST(Study, RefusesNumbersThatAreNotFinite) {
  EXPECT_EQ(refusal_after_problem("[budget]\nseconds = inf\n"),
            "s.toml:4: 'seconds' of [budget] must be finite, not inf");
  EXPECT_EQ(refusal_after_problem("[budget]\nseconds = -inf\n"),
            "s.toml:4: 'seconds' of [budget] must be finite, not -inf");
  EXPECT_EQ(refusal_after_problem("[budget]\nseconds = nan\n"),
            "s.toml:4: 'seconds' of [budget] must be finite, not nan");
  EXPECT_EQ(refusal_after_problem("best_known = { quality = nan, origin = \"x\" }\n"),
            "s.toml:3: 'quality' of 'best_known' of [problem] must be finite, not nan");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\noptions = { factor = nan }\n"),
            "s.toml:5: 'factor' of optimizer 'halving' must be finite, not nan");
}

TEST(Study, OffersTheNearestOfAnUnknownName) {
  EXPECT_EQ(refusal("[problem]\nkind = \"bowls\"\n"), "s.toml:2: unknown problem 'bowls'; did you mean 'bowl'?");
  EXPECT_EQ(refusal("[problem]\nkind = \"elastic\"\n"),
            "s.toml:2: unknown problem 'elastic'; valid: 'bowl', 'bare', 'broken', 'unspeakable', 'unmade'");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halfing\"\n"),
            "s.toml:4: unknown optimizer 'halfing'; did you mean 'halving' or 'hanging'?");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"\"\n"),
            "s.toml:4: unknown optimizer ''; valid: 'halving', 'wanderer', 'newton', 'walker', 'aborting', 'hanging', "
            "'leaving', 'throwing', 'throwing-a-number', 'unmade', 'latin', 'talkative' and 1 more");
}

TEST(Study, TakesSeveralLabelsAtOnceAndLabelsWithCommas) {
  const std::string text =
      "[problem]\nkind = \"bowl\"\n[[optimizer]]\nuse = \"halving\"\n[[optimizer]]\nuse = \"halving\"\nlabel = "
      "\"halving, again\"\n[[optimizer]]\nuse = \"wanderer\"\n";
  const auto kept = [&](std::vector<std::string> only) {
    StudyOverrides overrides;
    overrides.only = std::move(only);
    std::vector<std::string> labels;
    for (const StudyOptimizer& optimizer : parse_study(text, "s.toml", toy::registry(), overrides).optimizers)
      if (!optimizer.skipped) labels.push_back(optimizer.label);
    return labels;
  };
  EXPECT_EQ(kept({"halving,wanderer"}), (std::vector<std::string>{"halving", "wanderer"}));
  EXPECT_EQ(kept({"halving, again"}), (std::vector<std::string>{"halving, again"}));
  EXPECT_EQ(kept({"halving, again", "wanderer"}), (std::vector<std::string>{"halving, again", "wanderer"}));
}

TEST(Study, KeepsOnlyTheOneEntryThatUsesAMethod) {
  const std::string text =
      "[problem]\nkind = \"bowl\"\n[[optimizer]]\nuse = \"halving\"\nlabel = \"a\"\n"
      "[[optimizer]]\nuse = \"wanderer\"\nlabel = \"halving\"\n"
      "[[optimizer]]\nuse = \"newton\"\nlabel = \"b\"\n[[optimizer]]\nuse = \"newton\"\nlabel = \"c\"\n";
  const auto kept = [&](const std::string& word) {
    StudyOverrides overrides;
    overrides.only = {word};
    std::string labels;
    for (const StudyOptimizer& optimizer : parse_study(text, "s.toml", toy::registry(), overrides).optimizers)
      if (!optimizer.skipped) labels += optimizer.label;
    return labels;
  };
  EXPECT_EQ(kept("wanderer"), "halving");  // by its method
  EXPECT_EQ(kept("halving"), "halving");   // a label comes first
  EXPECT_EQ(toy::message_of([&] { (void)kept("newton"); }),
            "--only: several entries of the study use 'newton': 'b', 'c'; give their labels");
}

TEST(Study, RefusesTwoEqualLabels) {
  EXPECT_EQ(refusal("[[problem]]\nkind = \"bowl\"\n[[problem]]\nkind = \"bowl\"\nsize = 4\n"),
            "s.toml:3: two problems have the label 'bowl' (the other is on line 1); give one a 'label' of its own");
  EXPECT_EQ(refusal("[[problem]]\nkind = \"bowl\"\n[[problem]]\nkind = \"bare\"\nlabel = \"bowl\"\n"),
            "s.toml:3: two problems have the label 'bowl' (the other is on line 1); give one a 'label' of its own");
  EXPECT_EQ(
      refusal_after_problem("[[optimizer]]\nuse = \"halving\"\n[[optimizer]]\nuse = \"halving\"\n"),
      "s.toml:5: two optimizers have the label 'halving' (the other is on line 3); give one a 'label' of its own");
  EXPECT_EQ(refusal_after_problem(
                "[[optimizer]]\nuse = \"nlopt-a\"\nlabel = \"w\"\n[[optimizer]]\nuse = \"wanderer\"\nlabel = \"w\"\n"),
            "s.toml:6: two optimizers have the label 'w' (the other is on line 3); give one a 'label' of its own");
}

TEST(Study, RefusesAnEmptyLabel) {
  EXPECT_EQ(refusal_after_problem("label = \"\"\n"),
            "s.toml:3: 'label' of [problem] is empty; it names rows and results");
  for (const std::string& label : {std::string(101, 'x'), std::string(5'000'000, 'x')}) {
    const std::string said = "has " + std::to_string(label.size()) + " characters; at most 100 are allowed";
    EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\nlabel = \"" + label + "\"\n"),
              "s.toml:5: 'label' of [[optimizer]] " + said);
    EXPECT_EQ(refusal_after_problem("label = \"" + label + "\"\n"), "s.toml:3: 'label' of [problem] " + said);
    EXPECT_EQ(refusal("[study]\nname = \"" + label + "\"\n[problem]\nkind = \"bowl\"\n"),
              "s.toml:2: 'name' of [study] " + said);
  }
  std::string greek;
  for (int i = 0; i < 100; ++i) greek += "ν";
  EXPECT_EQ(refusal_after_problem("label = \"" + greek + "\"\n"), "(nothing was thrown)");
  EXPECT_EQ(refusal_after_problem("best_known = { quality = 0.0, origin = \"" + std::string(1001, 'o') + "\" }\n"),
            "s.toml:3: 'origin' of best_known has 1001 characters; at most 1000 are allowed");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\nlabel = \"failed\"\n"),
            "s.toml:5: an optimizer can't be labelled 'failed': --rerun failed means the trials that failed");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\nlabel = \"contaminated\"\n"),
            "s.toml:5: an optimizer can't be labelled 'contaminated': --rerun contaminated means the trials that were "
            "disturbed");
  EXPECT_EQ(refusal_after_problem("label = \"failed\"\n"), "(nothing was thrown)");  // of a problem
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"halving\"\nlabel = \"\"\n"),
            "s.toml:5: 'label' of [[optimizer]] is empty; it names rows and results");
}

TEST(Study, LetsAProblemAndAnOptimizerShareALabel) {
  EXPECT_NO_THROW(
      (void)study("[problem]\nkind = \"bowl\"\nlabel = \"x\"\n[[optimizer]]\nuse = \"halving\"\nlabel = \"x\"\n"));
}

TEST(Study, RefusesAnOptimizerThatNeedsWhatAProblemLacks) {
  EXPECT_EQ(refusal("[[problem]]\nkind = \"bowl\"\n[[problem]]\nkind = \"bare\"\n[[optimizer]]\nuse = \"newton\"\n"),
            "s.toml:5: optimizer 'newton' needs gradient and residuals, which problem 'bare' can't give");
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"walker\"\nlabel = \"w\"\n"),
            "s.toml:3: optimizer 'w' needs moves, which problem 'bowl' can't give");
  EXPECT_NO_THROW((void)study("[problem]\nkind = \"bowl\"\n[[optimizer]]\nuse = \"newton\"\n"));
}

TEST(Study, AsksNothingOfAnOptimizerThatOnlyLeavesOut) {
  StudyOverrides overrides;
  overrides.only = {"halving"};
  EXPECT_NO_THROW(
      (void)study("[problem]\nkind = \"bare\"\n"
                  "[[optimizer]]\nuse = \"newton\"\n"
                  "[[optimizer]]\nuse = \"halving\"\n",
                  overrides));
}

TEST(Study, PassesOnWhatAProblemRefuses) {
  EXPECT_EQ(refusal_after_problem("even = true\n"), "s.toml:1: an even bowl needs an even size");
}

TEST(Study, SaysWhatAsksForMoreMemoryThanThereIs) {
  Registry greedy = toy::registry();
  greedy.add(ProblemDescription{
      .kind = "greedy",
      .make = [](const Options&, const ProblemContext&) -> std::shared_ptr<const Problem> { throw std::bad_alloc(); }});
  EXPECT_EQ(toy::message_of([&] { (void)parse_study("[problem]\nkind = \"greedy\"\n", "s.toml", greedy); }),
            "s.toml:1: problem 'greedy' takes more memory than there is; make it smaller");
}

TEST(Study, SaysWhichProblemThrewWhenItWasMade) {
  Registry throwing;
  throwing.add(ProblemDescription{.kind = "own",
                                  .make = [](const Options&, const ProblemContext&) -> std::shared_ptr<const Problem> {
                                    throw std::out_of_range("vector::at");
                                  }});
  throwing.add(ProblemDescription{
      .kind = "odd", .make = [](const Options&, const ProblemContext&) -> std::shared_ptr<const Problem> { throw 7; }});
  const auto said = [&](const std::string& text) {
    return toy::message_of([&] { (void)parse_study(text, "s.toml", throwing); });
  };
  EXPECT_EQ(said("\n[problem]\nkind = \"own\"\nlabel = \"mine\"\n"),
            "s.toml:2: problem 'mine' can't be made: vector::at");
  EXPECT_EQ(said("[problem]\nkind = \"odd\"\n"),
            "s.toml:1: problem 'odd' can't be made: an exception that is no std::exception");
}

TEST(Study, RefusesMultiStartOfAGlobalMethod) {
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"wanderer\"\nlabel = \"w\"\nmulti_start = true\n"),
            "s.toml:6: 'multi_start' of optimizer 'w' gives a method many starts; 'wanderer' looks at none");
}

TEST(Study, RefusesASecondBaseline) {
  EXPECT_EQ(
      refusal_after_problem(
          "[[optimizer]]\nuse = \"halving\"\nbaseline = true\n[[optimizer]]\nuse = \"wanderer\"\nbaseline = true\n"),
      "s.toml:8: optimizer 'wanderer' is a second baseline; only one can be");
}

TEST(Study, RefusesATargetWithoutABestKnownQuality) {
  EXPECT_EQ(
      refusal("[budget]\nseconds = 1\ntarget_gap = 0.1\n[problem]\nkind = \"bare\"\n"),
      "s.toml:3: 'target_gap' needs to know the best quality of problem 'bare'; give it best_known = { quality = …, "
      "origin = \"…\" }");
  EXPECT_NO_THROW(
      (void)study("[budget]\ntarget_gap = 0.1\n[problem]\nkind = \"bare\"\n"
                  "best_known = { quality = 0, origin = \"x\" }\n"));
}

TEST(Study, LeavesOutWhatThisBuildLacksAndSaysWhy) {
  const Study s = study(
      "[problem]\nkind = \"bowl\"\n[[optimizer]]\nuse = \"nlopt-crs2-lm\"\nlabel = \"crs\"\noptions = { population = 3 "
      "}\n"
      "[[optimizer]]\nuse = \"halving\"\n");
  ASSERT_EQ(s.optimizers.size(), 1u);
  ASSERT_EQ(s.left_out.size(), 1u);
  EXPECT_EQ(s.left_out[0].label, "crs");
  EXPECT_EQ(s.left_out[0].use, "nlopt-crs2-lm");
  EXPECT_EQ(s.left_out[0].reason, "needs NLopt: configure with -DNODAL_NLOPT=ON");
}

TEST(Study, RefusesARaceInWhichEveryOptimizerIsAbsent) {
  EXPECT_EQ(refusal_after_problem("[[optimizer]]\nuse = \"nlopt-a\"\n[[optimizer]]\nuse = \"nlopt-b\"\n"),
            "s.toml: none of the study's optimizers can run: 'nlopt-a' needs NLopt: configure with -DNODAL_NLOPT=ON");
}

TEST(Study, RefusesToKeepOnlyWhatItLacks) {
  const auto only = [](const char* label) {
    StudyOverrides overrides;
    overrides.only = {"halving", label};
    return refusal_after_problem("[[optimizer]]\nuse = \"halving\"\n[[optimizer]]\nuse = \"nlopt-a\"\n", overrides);
  };
  EXPECT_EQ(only("halfing"), "--only: no optimizer of the study is labelled 'halfing'; did you mean 'halving'?");
  EXPECT_EQ(only("nlopt-a"),
            "--only: optimizer 'nlopt-a' is not in this build: needs NLopt: configure with -DNODAL_NLOPT=ON");
}

TEST(Study, RefusesANameThatIsNoFolder) {
  for (const char* name : {"", ".", "..", ".hidden", "a/b", "a\\\\b"}) {
    const std::string said = std::string(name) == "a\\\\b" ? "a\\b" : name;
    EXPECT_EQ(refusal_after_problem("[study]\nname = \"" + std::string(name) + "\"\n"),
              "s.toml:4: '" + said + "' can't be the name of a study: it names a folder");
  }
  for (const char* name : {"a\\nb", "a\\u0000b", "\\t"})  // a message ends at NUL: its beginning is compared
    EXPECT_TRUE(refusal_after_problem("[study]\nname = \"" + std::string(name) + "\"\n").starts_with("s.toml:4: '"))
        << name;
  EXPECT_EQ(toy::message_of([] { (void)parse_study("[problem]\nkind = \"bowl\"\n", "", toy::registry()); }),
            "'' can't be the name of a study: it names a folder");
  EXPECT_EQ(study("[study]\nname = \"Platte 2 – fein\"\n[problem]\nkind = \"bowl\"\n").name, "Platte 2 – fein");
}

TEST(Study, NamesTheLineOfASyntaxError) {
  const std::pair<const char*, int> texts[] = {{"[study\n", 1},       {"[study]\nseed = \n", 2},
                                               {"a = 1\na = 2\n", 2}, {"[study]\n\nseed = 1 2\n", 3},
                                               {"x = \"\xff\"\n", 1}, {"[a]\n[a]\n", 2}};
  for (const auto& [text, line] : texts) {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with("s.toml:" + std::to_string(line) + ": not valid TOML: "))
        << text << " → " << message;
  }
}

TEST(Study, RefusesDatesAndTimes) {
  EXPECT_EQ(refusal_after_problem("[study]\nname = 2024-01-01\n"), "s.toml:4: dates and times mean nothing here");
  EXPECT_EQ(refusal_after_problem("size = 12:30:00\n"), "s.toml:3: dates and times mean nothing here");
  EXPECT_EQ(refusal_after_problem("x = [1, { y = 2024-01-01T00:00:00Z }]\n"),
            "s.toml:3: dates and times mean nothing here");
}

TEST(Study, IsReadFromAFile) {
  const toy::TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "my toys.toml";
  std::ofstream(path) << "\xEF\xBB\xBF[problem]\r\nkind = \"bowl\"\r\n";  // as some editors write it
  const Study s = read_study(path, toy::registry());
  EXPECT_EQ(s.name, "my toys");
  EXPECT_EQ(s.path, path);
  EXPECT_EQ(s.problems.size(), 1u);
}

TEST(Study, RefusesAFileThatCannotBeRead) {
  const toy::TemporaryDirectory directory;
  const auto message = [](const std::filesystem::path& path) {
    return toy::message_of([&] { (void)read_study(path, toy::registry()); });
  };
  const std::string d = directory.path().string();
  EXPECT_EQ(message(d + "/none.toml"), "cannot read study '" + d + "/none.toml': No such file or directory");
  EXPECT_EQ(message(d), "cannot read study '" + d + "': Is a directory");
  std::ofstream(d + "/empty.toml").close();
  EXPECT_EQ(message(d + "/empty.toml"), d + "/empty.toml: missing table [problem]; a study needs one");
  EXPECT_EQ(message(d + "/empty.toml/x.toml"), "cannot read study '" + d + "/empty.toml/x.toml': Not a directory");
  EXPECT_EQ(message("/proc/self/mem"), "cannot read study '/proc/self/mem': Input/output error");
  EXPECT_TRUE(message(d + "/" + std::string(300, 'x')).ends_with(": File name too long"));
}

TEST(Study, KeepsTheLinesOfInlineTables) {
  const Study s =
      study("[problem]\nkind = \"bowl\"\n\nsize = 4\n[[optimizer]]\nuse = \"halving\"\noptions = { factor = 0.5 }\n");
  EXPECT_EQ(s.problems[0].options.at("size").source.text(), "s.toml:4");
  EXPECT_EQ(s.optimizers[0].options.values().source.line, 7);
}

}  // namespace
}  // namespace nodal
