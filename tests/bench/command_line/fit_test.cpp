// SPDX-License-Identifier: GPL-3.0-or-later
// What `nodal fit` says of its method, its budget, how it ended and what it leaves open; where its results go.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

#include <nodal/components.h>
#include <nodal/trial.h>
#include <nodal/value.h>

#include <nodal/show/at_bounds.h>
#include "command_line/fit_clock.h"
#include "command_line/fit_method.h"
#include "command_line/slope.h"
#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// The quick study without [budget].
std::string without_budget() {
  std::string text = kQuickStudy;
  const std::size_t at = text.find("[budget]");
  return text.erase(at, text.find("[problem]") - at);
}

// ── method and budget

TEST(FitMethod, TakesTheOptionsOfTheStudysEntry) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy +
                                 "label = \"mine\"\n[[optimizer]]\nuse = \"gauss-newton\"\nlabel = \"short\"\n"
                                 "options = { max_iterations = 1 }\n");
  const Output by_use = run(folder, {"fit", "quick.toml", "--with", "gauss-newton"});
  EXPECT_EQ(by_use.exit, 0) << by_use.err;
  EXPECT_TRUE(
      contains(by_use.err, "with short: the study's entry that uses it; at most 300 evaluations, as the study says"))
      << by_use.err;
  EXPECT_TRUE(contains(by_use.err, "stopped by the method's own limit, not converged; k_max/k_min ")) << by_use.err;
  EXPECT_TRUE(contains(run(folder, {"fit", "quick.toml", "--with", "mine"}).err, "the study's entry of that label"));
}

TEST(FitMethod, OfSeveralEntriesMustBeNamedByLabel) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy + "label = \"a\"\n[[optimizer]]\nuse = \"random-search\"\nlabel = \"b\"\n");
  const Output output = run(folder, {"fit", "quick.toml", "--with", "random-search"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: --with: 2 entries of the study use 'random-search'; take one by its label: a, b\n");
}

TEST(FitBudget, IsSaid) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  folder.write("free.toml", without_budget());
  EXPECT_TRUE(contains(run(folder, {"fit", "free.toml", "--with", "gauss-newton"}).err,
                       "; at most 60 s, the default: --seconds or --evaluations give another\n"));
  const Output asked = run(folder, {"fit", "free.toml", "--with", "random-search", "--evaluations", "20"});
  EXPECT_TRUE(contains(asked.err, "; at most 20 evaluations, as asked for\n")) << asked.err;
  EXPECT_TRUE(
      contains(asked.err, "\nstopped by its budget, not converged; more by --seconds or --evaluations; k_max/k_min "))
      << asked.err;
}

TEST(FitEnd, SaysThatItConvergedAndWhatIsAtABound) {
  const Folder folder;
  folder.write("free.toml", without_budget());
  const Output output = run(folder, {"fit", "free.toml", "--with", "gauss-newton"});
  EXPECT_TRUE(contains(output.err, "\nconverged; k_max/k_min ")) << output.err;
  EXPECT_TRUE(contains(output.err, "; no coordinate at a bound\n")) << output.err;
  folder.write("narrow.toml", without_budget() + "[problem.springs]\nbounds = [0.38, 0.5]\n");
  const Output narrow = run(folder, {"fit", "narrow.toml", "--with", "gauss-newton", "--export", "n.json"});
  EXPECT_TRUE(contains(narrow.err, " of 20 coordinates at the lower bound, ")) << narrow.err;
  EXPECT_TRUE(contains(narrow.err, " at the upper\n")) << narrow.err;
  const Output evaluated = run(folder, {"evaluate", "narrow.toml", "--stiffness", "n.json"});
  const std::size_t begin = narrow.err.find("; ", narrow.err.find("; k_max/k_min ") + 2) + 2;
  const std::string counts = narrow.err.substr(begin, narrow.err.find('\n', begin) - begin);
  EXPECT_TRUE(contains(evaluated.out, "\n" + counts + " (0.38 to 0.5 N/m)\n")) << counts << evaluated.out;
}

// The plate's start is no minimum and its fit is one, whatever the method said of either.
TEST(Slope, IsNearlyZeroAtAMinimumAndNowhereElse) {
  const Folder folder;
  folder.write("free.toml", without_budget());
  Registry registry;
  register_components(registry);
  Study study = read_study(folder.path() / "free.toml", registry);
  const Problem& problem = *study.problems.front().problem;
  const Space& space = problem.space();
  EXPECT_GT(promised_share(problem, space.start()).value(), 100.0 * kSlopeOfAMinimum);
  study.budget.evaluations = 500;
  study.optimizers = {named_method("gauss-newton", study, registry).optimizer};
  TrialRecord record = run_trial(study, {0, 0, 0}, registry);
  ASSERT_TRUE(record.best.has_value());
  EXPECT_LT(promised_share(problem, record.best->x).value(), kSlopeOfAMinimum);
  EXPECT_EQ(ending_text(record, problem, registry), "converged");
  record.best->x.assign(space.start().begin(), space.start().end());
  EXPECT_TRUE(ending_text(record, problem, registry).starts_with("stopped by the method, not converged: a step of "));
}

TEST(AtBounds, CountsBothSides) {
  const Space space({{"a", 0, 1, 0}, {"b", 0, 1, 0}, {"c", -2, 1, 0}});
  const auto text = [&](double a, double b, double c) { return at_bounds_text(space, std::vector{a, b, c}); };
  EXPECT_EQ(text(0.5, 0.1, 0), "no coordinate at a bound");
  EXPECT_EQ(text(0, 0.1, -2), "2 of 3 coordinates at the lower bound");
  EXPECT_EQ(text(1, 0.1, 0), "1 of 3 coordinates at the upper bound");
  EXPECT_EQ(text(1.5, 1, -2), "1 of 3 coordinates at the lower bound, 2 at the upper");
}

// On a terminal only, and nothing is left of it.
TEST(FitClock, ShowsTheTimeOnATerminal) {
  std::ostringstream shown;
  std::streambuf* const former = std::cerr.rdbuf(shown.rdbuf());
  for (const bool terminal : {false, true}) {
    const FitClock clock(terminal, 60.0, std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    if (!terminal) {
      EXPECT_EQ(shown.str(), "");
    }
  }
  std::cerr.rdbuf(former);
  EXPECT_TRUE(contains(shown.str(), "0 s of at most 60 s")) << shown.str();
  EXPECT_TRUE(shown.str().ends_with("\x1b[K")) << shown.str();
}

// ── pruning

// Diagonals that start at the lower bound and may not be missed much: the others are fitted again.
TEST(FitPrune, KeepsWithinTheLimitAndFitsAgain) {
  const Folder folder;
  folder.write("narrow.toml", without_budget() + "[problem.springs]\nbounds = [0.39, 100]\n");
  const Output plain = run(folder, {"fit", "narrow.toml", "--with", "gauss-newton", "--export", "all.json"});
  const Output tight =
      run(folder, {"fit", "narrow.toml", "--with", "gauss-newton", "--prune", "--export", "tight.json"});
  const Output loose = run(folder, {"fit", "narrow.toml", "--with", "gauss-newton", "--prune", "--prune-loss", "100",
                                    "--export", "loose.json"});
  EXPECT_EQ(tight.exit, 0) << tight.err;
  EXPECT_EQ(loose.exit, 0) << loose.err;
  EXPECT_TRUE(contains(tight.err, "kept because the error would grow too much")) << tight.err;
  EXPECT_TRUE(contains(loose.err, "\nfitted again: gauss-newton, repeat 0: relative error ")) << loose.err;
  const auto springs = [&](const char* file) {
    return parse_json(read_file(folder.path() / file), file).at("springs").list().size();
  };
  EXPECT_LT(springs("loose.json"), springs("tight.json"));
  EXPECT_LE(springs("tight.json"), springs("all.json"));
  const Output alone = run(folder, {"fit", "narrow.toml", "--prune-loss", "0.1"});
  EXPECT_EQ(alone.exit, 2);
}

// ── where results go

TEST(FitExport, TakesJsonInEitherCaseAndNothingElse) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  for (const char* name : {"f.vtk", "f.csv", "f.inp", "f", "quick.toml"}) {
    const Output output = run(folder, {"fit", "quick.toml", "--export", name});
    EXPECT_EQ(output.exit, 2) << name;
    EXPECT_EQ(output.err, "nodal: --export: '" + std::string(name) +
                              "' doesn't end in .json; what is fitted is written as JSON, e.g. fitted.json\n");
  }
  EXPECT_EQ(run(folder, {"fit", "quick.toml", "--export", "F.JSON", "--picture", "F.SVG"}).exit, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "F.JSON"));
  EXPECT_TRUE(run(folder, {"fit", "quick.toml", "--export", "/dev/stdout"}).out.starts_with("{\"schema\": 1,"));
}

// What is checked before a fit is looked at only: nothing is made, and a FIFO without a reader isn't waited for.
TEST(FitExport, IsCheckedWithoutBeingOpened) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  ASSERT_EQ(::mkfifo((folder.path() / "fifo").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((folder.path() / "fifo.svg").c_str(), 0600), 0);
  const Output refused = run(folder, {"fit", "quick.toml", "--export", "fifo", "--picture", "no/where.svg"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_EQ(
      refused.err,
      "nodal: --picture: cannot write 'no/where.svg': there is no folder 'no'; give a file in a folder that exists "
      "and may be written\n");
  EXPECT_EQ(run(folder, {"fit", "quick.toml", "--export", "new.json", "--picture", "no/where.svg"}).exit, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "new.json"));
  EXPECT_TRUE(contains(run(folder, {"fit", "quick.toml", "--export", "."}).err, "--export: '.' doesn't end in .json"));
  std::filesystem::create_directory(folder.path() / "d.json");
  EXPECT_TRUE(
      contains(run(folder, {"fit", "quick.toml", "--export", "d.json"}).err, "cannot write 'd.json': it is a folder"));
}

TEST(FitExport, FollowsLinks) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  std::filesystem::create_directory(folder.path() / "there");
  std::filesystem::create_symlink("there/real.json", folder.path() / "link.json");
  EXPECT_EQ(run(folder, {"fit", "quick.toml", "--export", "link.json"}).exit, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "there" / "real.json"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.json"));
}

// ── systems of one's own

// A king post truss of which one node was measured, brought without stiffnesses.
void write_king_post(const Folder& folder) {
  folder.write("nodes.csv", "node,x,y\n1,0,0\n2,2.5,0\n3,2.5,2\n4,5,0\n");
  folder.write("pairs.csv", "first,second\n1,2\n1,3\n2,4\n3,2\n3,4\n");
  folder.write("displacements.csv", "node,ux,uy\n3,0.0,-0.0012011717319488785\n");
  folder.write(
      "king.toml",
      "[problem]\nkind = \"elastic\"\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"pairs.csv\" }\n"
      "reference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"snow\"\nsupports = [{ nodes "
      "= [1, 4] }]\nforces = [{ nodes = [3], force = [0.0, -20.0] }]\n");
}

TEST(FitOwnSystem, EndsOffItsBoundsAndNamesWhatIsArbitrary) {
  const Folder folder;
  write_king_post(folder);
  const Output output = run(folder, {"fit", "king.toml", "--with", "gauss-newton", "--export", "f.json"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.err, "; no coordinate at a bound\n")) << output.err;
  const std::string note =
      "note: 2 known displacements can't determine 5 stiffnesses: 3 are arbitrary, (1, 2), (2, 4), (2, 3)";
  EXPECT_TRUE(contains(output.err, note)) << output.err;
  const Value springs = parse_json(read_file(folder.path() / "f.json"), "f.json").at("springs");
  EXPECT_NEAR(springs.list()[1].at("stiffness").number(), 21333.33587398359, 1e-6);
  EXPECT_TRUE(contains(run(folder, {"evaluate", "king.toml", "--stiffness", "f.json"}).out, note));
  EXPECT_TRUE(contains(run(folder, {"explain", "king.toml"}).out, note));
  const Value state = parse_json(run(folder, {"evaluate", "king.toml", "--json"}).out, "stdout");
  EXPECT_EQ(state.at("undetermined").list().size(), 3u);
}

// A race tells it, too: with the figures of any of its rows, and again where a report is made of the store.
TEST(FitOwnSystem, IsSaidToBeOpenBelowATable) {
  const Folder folder;
  write_king_post(folder);
  folder.write("race.toml", read_file(folder.path() / "king.toml") +
                                "[study]\nname = \"race\"\nrepeats = 1\n[budget]\nevaluations = 50\n"
                                "[[optimizer]]\nuse = \"annealing\"\n");
  const std::string note = "\nAt the start: 2 known displacements can't determine 5 stiffnesses: 3 are arbitrary";
  const Output race = run(folder, {"compare", "race.toml"});
  EXPECT_EQ(race.exit, 0) << race.err;
  EXPECT_TRUE(contains(race.out, note)) << race.out;
  EXPECT_TRUE(contains(run(folder, {"report", "results/race"}).out, note));
  EXPECT_TRUE(contains(read_file(folder.path() / "results/race/report.html"), "determine 5 stiffnesses"));
}

// What a fit writes is all that another study needs: the same groups, bounds, error, as points and springs and as a
// start.
TEST(FitOwnSystem, ComesBackFromItsExport) {
  const Folder folder;
  folder.write("nodes.csv", "node,x,y,mass\n1,0,0,1\n2,4,0,1\n3,2,3,2\n");
  folder.write("springs.csv", "first,second,stiffness,group\n1,2,5,chord\n1,3,5.5,leg\n2,3,5.5,leg\n");
  folder.write("disp.csv", "node,ux,uy\n3,0.1,-0.2\n");
  const std::string rest =
      " }\nreference = { file = \"disp.csv\" }\n[[problem.loads.cases]]\nname = \"load\"\nsupports = [{ nodes = [1] }, "
      "{ "
      "nodes = [2], fix = \"y\" }]\nforces = [{ nodes = [3], force = [0.373, -1.431] }]\n";
  const auto study = [&](const std::string& name, const std::string& points, const std::string& springs) {
    folder.write(name, "[problem]\nkind = \"elastic\"\npoints = { file = \"" + points +
                           "\" }\nsprings = { parameters = \"groups\", " + springs + rest);
  };
  study("g.toml", "nodes.csv", "file = \"springs.csv\"");
  const Output fit = run(folder, {"fit", "g.toml", "--with", "gauss-newton", "--export", "fitted.json"});
  ASSERT_EQ(fit.exit, 0) << fit.err;
  EXPECT_TRUE(contains(fit.err, "1 of 2 coordinates at the upper bound")) << fit.err;
  const Value fitted = parse_json(read_file(folder.path() / "fitted.json"), "fitted.json");
  std::string groups;
  for (const Value& spring : fitted.at("springs").list()) groups += spring.at("group").text() + " ";
  EXPECT_EQ(groups, "chord leg leg ");
  EXPECT_EQ(fitted.at("nodes").list()[2].at("mass").number(), 2.0);

  const auto state = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"evaluate", "--json"});
    const Output output = run(folder, arguments);
    EXPECT_EQ(output.exit, 0) << output.err;
    return output.exit == 0 ? parse_json(output.out, "stdout") : Value();
  };
  const Value expected = state({"g.toml", "--stiffness", "fitted.json"});
  study("back.toml", "fitted.json", "file = \"fitted.json\"");
  study("start.toml", "nodes.csv", "file = \"springs.csv\", initial = { file = \"fitted.json\" }");
  for (const char* again : {"back.toml", "start.toml"}) {
    EXPECT_EQ(to_json(state({again})), to_json(expected)) << again;
    const Output refit = run(folder, {"fit", again, "--with", "gauss-newton", "--export", "again.json"});
    EXPECT_EQ(refit.exit, 0) << refit.err;
    EXPECT_TRUE(contains(refit.err, "(2 coordinates)")) << refit.err;
    const Value second = parse_json(read_file(folder.path() / "again.json"), "again.json");
    EXPECT_EQ(second.at("bounds"), fitted.at("bounds")) << again;
    EXPECT_EQ(second.at("springs").list()[0].at("stiffness"), fitted.at("springs").list()[0].at("stiffness")) << again;
  }
}

void write_triangle(const Folder& folder) {
  folder.write("nodes.csv", "node,x,y\n1,0,0\n2,0,12\n3,10,0\n");
  folder.write("springs.csv", "first,second,stiffness\n1,2,300\n2,3,500\n3,1,100\n");
  folder.write(
      "solve.toml",
      "[budget]\nevaluations = 10\n[[optimizer]]\nuse = \"random-search\"\n[problem]\nkind = \"elastic\"\npoints = "
      "{ file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n[[problem.loads.cases]]\nname = \"load\"\n"
      "supports = [{ nodes = [1] }, { nodes = [2], fix = \"x\" }]\nforces = [{ nodes = [3], force = [0.0, 500.0] "
      "}]\n");
}

TEST(EvaluateOnlySolved, ShowsDisplacementsAndForces) {
  const Folder folder;
  write_triangle(folder);
  const Output text = run(folder, {"evaluate", "solve.toml", "--picture", "s.svg"});
  EXPECT_EQ(text.exit, 0) << text.err;
  for (const char* line :
       {"no reference to compare with", "3        4.1666667        6.8333333", "2          3       -650.85414",
        "1          x       -416.66667", "1          y             -500", "2          x        416.66667"})
    EXPECT_TRUE(contains(text.out, line)) << line << text.out;
  const Value state = parse_json(run(folder, {"evaluate", "solve.toml", "--json"}).out, "stdout");
  EXPECT_EQ(state.find("quality"), nullptr);
  const Value& load = state.at("loads").list()[0];
  EXPECT_EQ(load.find("reference"), nullptr);
  EXPECT_NEAR(load.at("displacement").list()[2].list()[1].number(), 41.0 / 6.0, 1e-13);
  EXPECT_NEAR(load.at("force").list()[0].number(), 500.0, 1e-11);
  EXPECT_NEAR(load.at("bearing").list()[2].list()[2].number(), 1250.0 / 3.0, 1e-11);
}

TEST(EvaluateOnlySolved, CannotBeFittedOrCompared) {
  const Folder folder;
  write_triangle(folder);
  for (const char* command : {"fit", "compare"}) {
    const Output output = run(folder, {command, "solve.toml"});
    EXPECT_EQ(output.exit, 2) << command;
    EXPECT_TRUE(contains(output.err, "cases of your own need reference = { file = \"displacements.csv\" }"))
        << output.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
  const Output explained = run(folder, {"explain", "solve.toml"});
  EXPECT_EQ(explained.exit, 0);
  EXPECT_TRUE(contains(explained.out, "at the start: only to be evaluated")) << explained.out;
}

}  // namespace
}  // namespace nodal::program
