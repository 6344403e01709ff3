// SPDX-License-Identifier: GPL-3.0-or-later
// The commands as a user runs them: what goes to stdout, what to stderr, and the exit code.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include <nodal/value.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// The start of the folder's quick.toml, a grid of 3 × 3 nodes, as a stiffness file: diagonals at one stiffness, other
// springs at another, or as they were.
void write_start(const Folder& folder, const std::string& file, std::optional<double> others, double diagonals) {
  Value springs = parse_json(run(folder, {"evaluate", "quick.toml", "--json"}).out, "stdout").at("springs");
  for (Value& spring : springs.list()) {
    const Value::List& nodes = spring.at("nodes").list();
    const std::int64_t step = nodes[1].integer() - nodes[0].integer();
    if (step == 2 || step == 4)
      spring.set("stiffness", diagonals);
    else if (others)
      spring.set("stiffness", *others);
  }
  Value system;
  system.set("springs", std::move(springs));
  folder.write(file, to_json(system));
}

TEST(Compare, PrintsATableAndWritesTheReport) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output output = run(folder, {"compare", "quick.toml"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "annealing (baseline)")) << output.out;
  EXPECT_TRUE(contains(output.out, "random-search")) << output.out;
  EXPECT_TRUE(contains(output.err, "report: results/quick/report.html\n")) << output.err;
  for (const char* file : {"report.html", "summary.csv", "optimizers.csv", "budgets.csv", "manifest.json"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "results" / "quick" / file), 100u) << file;
  for (const auto& figure : std::filesystem::directory_iterator(folder.path() / "results" / "quick" / "figures"))
    EXPECT_TRUE(read_file(figure.path()).starts_with("<svg xmlns=")) << figure.path();
  EXPECT_EQ(count_lines(folder.path() / "results" / "quick" / "trials"), 4u);
}

TEST(Compare, SaysWhichToTake) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output output = run(folder, {"compare", "quick.toml"});
  const std::size_t at = output.out.find("\nWhich to take\n");
  ASSERT_NE(at, std::string::npos) << output.out;
  EXPECT_NE(output.out.find("\n  With ", at), std::string::npos) << output.out;
  EXPECT_NE(output.out.find("\n  Holds for 1 problem (", at), std::string::npos) << output.out;
  const std::string page = read_file(folder.path() / "results" / "quick" / "report.html");
  EXPECT_EQ(page.find("<h2>"), page.find("<h2>Which to take</h2>"));
}

TEST(Report, WritesTablesForLatex) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  ASSERT_EQ(run(folder, {"compare", "quick.toml"}).exit, 0);
  const Output output = run(folder, {"report", "results/quick", "--latex", "tables.tex"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.err, "written: tables.tex\n")) << output.err;
  EXPECT_TRUE(contains(read_file(folder.path() / "tables.tex"), "\\label{tab:answer}"));
}

TEST(Compare, RunsOnlyWhatIsMissing) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "store"}).exit, 0);
  const Output again = run(folder, {"compare", "quick.toml", "--out", "store"});
  EXPECT_EQ(again.exit, 0);
  EXPECT_TRUE(again.err.starts_with("4 of 4 trials are stored already\n")) << again.err;
  EXPECT_EQ(count_lines(folder.path() / "store" / "trials"), 4u);
  const Output more = run(folder, {"compare", "quick.toml", "--out", "store", "--repeats", "3", "--only", "annealing"});
  EXPECT_TRUE(more.err.starts_with("2 of 3 trials are stored already\nrunning 1 trial\n")) << more.err;
  EXPECT_EQ(count_lines(folder.path() / "store" / "trials"), 5u);
}

// Diagonals twenty decades softer than the rest: in double precision they aren't there, so annealing has nowhere to
// start.
TEST(Compare, ExitsWithOneWhenATrialFailed) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  write_start(folder, "soft.json", std::nullopt, 1e-20);
  std::string study = kQuickStudy;
  study.replace(study.find("points ="), 0, "springs = { initial = { file = \"soft.json\" }, bounds = [1e-30, 1e2] }\n");
  folder.write("soft.toml", study);
  const Output output = run(folder, {"compare", "soft.toml", "--only", "annealing", "--repeats", "1"});
  EXPECT_EQ(output.exit, 1) << output.err;
  const std::string reason = "the start can't be evaluated: the system can't carry its loads (not_positive_definite)";
  EXPECT_TRUE(contains(output.err, reason)) << output.err;
  for (const char* method : {"annealing-adaptive", "gauss-newton"}) {
    const Output fit = run(folder, {"fit", "soft.toml", "--with", method});
    EXPECT_EQ(fit.exit, 1) << method;
    EXPECT_TRUE(contains(fit.err, reason)) << fit.err;
  }
  const Output evaluated = run(folder, {"evaluate", "soft.toml"});
  EXPECT_EQ(evaluated.exit, 1);
  EXPECT_TRUE(contains(evaluated.err, "a mechanism or not supported: it gives way at node")) << evaluated.err;
}

TEST(Report, IsMadeAgainWithoutRunningAnything) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output compared = run(folder, {"compare", "quick.toml", "--out", "store"});
  const std::string page = read_file(folder.path() / "store" / "report.html");
  std::filesystem::remove(folder.path() / "store" / "report.html");
  std::filesystem::remove(folder.path() / "quick.toml");
  const Output output = run(folder, {"report", "store"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_EQ(output.out, compared.out);
  EXPECT_EQ(read_file(folder.path() / "store" / "report.html"), page);
}

TEST(Report, TakesAwayChartsThatItNoLongerHas) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  run(folder, {"compare", "quick.toml", "--out", "store"});
  const std::filesystem::path figures = folder.path() / "store" / "figures";
  const std::filesystem::path chart = std::filesystem::directory_iterator(figures)->path();
  std::filesystem::copy_file(chart, figures / "former-error-time.svg");
  folder.write("store/figures/mine.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>\n");
  EXPECT_EQ(run(folder, {"report", "store"}).exit, 0);
  EXPECT_TRUE(std::filesystem::exists(chart));
  EXPECT_TRUE(std::filesystem::exists(figures / "mine.svg"));
  EXPECT_FALSE(std::filesystem::exists(figures / "former-error-time.svg"));
}

TEST(Compare, TakesOneWordAfterOnlyAndRerun) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "--only", "annealing", "quick.toml", "--out", "a"}).exit, 0);
  const Output again = run(folder, {"compare", "--rerun", "annealing", "quick.toml", "--out", "a"});
  EXPECT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(count_lines(folder.path() / "a" / "trials"), 6u);  // two of each, and two again
  EXPECT_EQ(run(folder, {"trials", "--only", "annealing", "--only", "random-search", "quick.toml"}).exit, 0);
}

TEST(Report, MergesSeveralStores) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "a", "--only", "annealing"}).exit, 0);
  EXPECT_EQ(run(folder, {"compare", "quick.toml", "--out", "b", "--only", "random-search"}).exit, 0);
  const Output refused = run(folder, {"report", "a", "b"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_EQ(refused.err, "nodal: several stores make one report of their own; say where it goes with --out DIR\n");
  const Output output = run(folder, {"report", "a", "b", "--out", "both"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "annealing (baseline)") && contains(output.out, "random-search")) << output.out;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "both" / "report.html"));
}

TEST(Evaluate, TellsErrorPerLoadAndBearingForces) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output text = run(folder, {"evaluate", "quick.toml"});
  EXPECT_EQ(text.exit, 0);
  for (const char* load : {"stretch-x", "stretch-y", "shear-x", "shear-y"})
    EXPECT_TRUE(contains(text.out, load)) << text.out;
  const Output json = run(folder, {"evaluate", "quick.toml", "--json"});
  const Value state = parse_json(json.out, "stdout");
  EXPECT_EQ(state.at("nodes").integer(), 9);
  EXPECT_EQ(state.at("springs").list().size(), 20u);
  EXPECT_EQ(state.at("loads").list().size(), 4u);
  EXPECT_EQ(state.at("loads").list()[0].at("bearing").list().size(), 4u);
  EXPECT_LT(state.at("health").at("residual").number(), 1e-14);
}

// What may be wrong with a scene is told with its result, not in `explain` alone.
TEST(Evaluate, TellsOfNodesBesideTheOutline) {
  const Folder folder;
  folder.write("nodes.csv", "node,x,y\n1,0,0\n2,1,0\n3,0.9995,1\n4,0,1\n");
  folder.write("springs.csv", "first,second\n1,2\n2,3\n3,4\n4,1\n1,3\n2,4\n");
  folder.write("displacements.csv", "node,ux,uy\n3,1,0\n");
  const std::string study =
      "[problem]\nkind = \"elastic\"\nbody = { outline = [[0, 0], [1, 0], [1, 1.0005], [0, 1.0005]] }\n"
      "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n"
      "reference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"pull\"\n"
      "supports = [{ edge = \"left\" }, { nodes = [2], fix = \"y\" }]\nforces = [{ nodes = [3], force = [1, 0] }]\n";
  folder.write("near.toml", study);
  const std::string note = "note: 1 node is within 0.001 of the body's size of the outline but not on it: 3; ";
  EXPECT_TRUE(contains(run(folder, {"evaluate", "near.toml"}).err, note));
  EXPECT_TRUE(contains(run(folder, {"explain", "near.toml"}).out, note));
  EXPECT_TRUE(contains(run(folder, {"fit", "near.toml", "--with", "annealing", "--evaluations", "10"}).err, note));
}

// The system that a fit exports is the one that evaluate reads: the same error, to the last digits that JSON keeps.
TEST(Fit, ExportsWhatEvaluateReads) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output fit =
      run(folder, {"fit", "quick.toml", "--with", "annealing", "--evaluations", "2000", "--export", "fit.json"});
  EXPECT_EQ(fit.exit, 0) << fit.err;
  EXPECT_EQ(fit.out, "");
  const double start =
      parse_json(run(folder, {"evaluate", "quick.toml", "--json"}).out, "start").at("quality").number();
  const double fitted =
      parse_json(run(folder, {"evaluate", "quick.toml", "--json", "--stiffness", "fit.json"}).out, "fit")
          .at("quality")
          .number();
  EXPECT_LT(fitted, 0.5 * start);
}

std::size_t load_panels(const std::string& picture) {
  std::size_t found = 0;
  for (std::size_t at = picture.find("<g class=\"load\""); at != std::string::npos;
       at = picture.find("<g class=\"load\"", at + 1))
    ++found;
  return found;
}

TEST(Evaluate, DrawsTheSystemAndEachLoad) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output plain = run(folder, {"evaluate", "quick.toml"});
  const Output output = run(folder, {"evaluate", "quick.toml", "--picture", "start.svg"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_EQ(output.out, plain.out);
  EXPECT_EQ(output.err, "written: start.svg\n");
  const std::string picture = read_file(folder.path() / "start.svg");
  EXPECT_EQ(load_panels(picture), 4u + 2u);  // fitted ones, and bendings that never are
  EXPECT_TRUE(contains(picture, ">elastic: start</text>"));
  std::string three = kQuickStudy;
  three.insert(three.find("points ="), "loads = { supports = \"minimal\" }\n");
  folder.write("three.toml", three);
  EXPECT_EQ(run(folder, {"evaluate", "three.toml", "--picture", "three.svg"}).exit, 0);
  EXPECT_EQ(load_panels(read_file(folder.path() / "three.svg")), 3u + 2u);
}

// The picture of a fit is that of the fitted system: what evaluate draws of the exported file but for the title.
TEST(Fit, DrawsTheFittedSystem) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output fit =
      run(folder, {"fit", "quick.toml", "--with", "annealing", "--export", "k.json", "--picture", "k.svg"});
  EXPECT_EQ(fit.exit, 0) << fit.err;
  EXPECT_TRUE(contains(fit.err, "written: k.json\nwritten: k.svg\n")) << fit.err;
  const std::string fitted = read_file(folder.path() / "k.svg");
  EXPECT_EQ(load_panels(fitted), 4u + 2u);
  EXPECT_TRUE(contains(fitted, ">elastic: fitted by annealing</text>"));
  run(folder, {"evaluate", "quick.toml", "--picture", "start.svg"});
  run(folder, {"evaluate", "quick.toml", "--stiffness", "k.json", "--picture", "again.svg"});
  std::string again = read_file(folder.path() / "again.svg");
  for (std::size_t at = again.find("k.json"); at != std::string::npos; at = again.find("k.json"))
    again.replace(at, 6, "fitted by annealing");
  EXPECT_TRUE(again == fitted);
  EXPECT_FALSE(read_file(folder.path() / "start.svg") == fitted);
}

// Of a plate whose diagonals start at the lower bound, a fit of one evaluation gives the start back. Those go that no
// support group needs.
TEST(Fit, PrunesSpringsAtTheLowerBound) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  write_start(folder, "start.json", 1.0, 1e-4);
  folder.write("soft.toml", kQuickStudy + "[problem.springs]\ninitial = { file = \"start.json\" }\n");
  const Output output = run(folder, {"fit", "soft.toml", "--with", "annealing", "--evaluations", "1", "--prune",
                                     "--prune-loss", "1e3", "--export", "pruned.json", "--picture", "pruned.svg"});
  EXPECT_EQ(output.exit, 0) << output.err;
  const Value pruned = parse_json(read_file(folder.path() / "pruned.json"), "pruned.json");
  const std::size_t kept = pruned.at("springs").list().size();
  EXPECT_TRUE(
      contains(output.err, "pruned: " + std::to_string(20 - kept) + " of 20 springs at the lower bound left out"))
      << output.err;
  EXPECT_EQ(kept, 15u);  // a bending that is held out holds 3 of 18 freedoms and leaves 15 to be held by springs
  EXPECT_EQ(pruned.at("nodes").list().size(), 9u);
  EXPECT_TRUE(contains(read_file(folder.path() / "pruned.svg"), "fitted by annealing, pruned"));
}

TEST(Fit, WithoutSpringsPrunesNothing) {
  const Folder folder;
  folder.write("sphere.toml", "[budget]\nevaluations = 10\n[problem]\nkind = \"sphere\"\n");
  const Output output = run(folder, {"fit", "sphere.toml", "--prune"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: --prune: problem 'sphere' has nothing to leave out\n");
}

// Four nodes on a square without a diagonal, and a fifth that hangs on one spring.
TEST(Evaluate, DrawsAMechanismThatItRefuses) {
  const Folder folder;
  folder.write("nodes.csv", "node,x,y\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n");
  folder.write("springs.csv", "first,second\n1,2\n2,3\n3,4\n4,1\n1,3\n2,5\n");
  folder.write("displacements.csv", "node,ux,uy\n3,1,0\n");
  folder.write(
      "loose.toml",
      "[problem]\nkind = \"elastic\"\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n"
      "reference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"pull\"\n"
      "supports = [{ nodes = [1, 4] }]\nforces = [{ nodes = [3], force = [1, 0] }]\n");
  for (const char* command : {"evaluate", "fit"}) {
    const Output output = run(folder, {command, "loose.toml", "--picture", "loose.svg"});
    EXPECT_EQ(output.exit, 2);
    EXPECT_TRUE(contains(output.err, "written: loose.svg\n")) << output.err;
    EXPECT_TRUE(contains(output.err,
                         "loose.toml:4: the net is a mechanism under the supports of pull: a motion without "
                         "resistance moves node 5; join them by more springs, or look at it with --picture"))
        << output.err;
    EXPECT_TRUE(contains(read_file(folder.path() / "loose.svg"), "loose: a mechanism"));
    std::filesystem::remove(folder.path() / "loose.svg");
  }
}

TEST(Fit, WithoutSpringsHasNoPicture) {
  const Folder folder;
  folder.write("sphere.toml", "[budget]\nevaluations = 10\n[problem]\nkind = \"sphere\"\n");
  for (const char* command : {"fit", "evaluate"}) {
    const Output output = run(folder, {command, "sphere.toml", "--picture", "sphere.svg"});
    EXPECT_EQ(output.exit, 2) << command;
    EXPECT_EQ(output.err, "nodal: --picture: problem 'sphere' has no picture\n");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "sphere.svg"));
  }
}

// Refused before the work, so nothing is left where nothing was.
TEST(Evaluate, WithoutAnEquilibriumLeavesNoPicture) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  write_start(folder, "soft.json", std::nullopt, 1e-20);
  EXPECT_EQ(run(folder, {"evaluate", "quick.toml", "--stiffness", "soft.json", "--picture", "soft.svg"}).exit, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "soft.svg"));
}

TEST(Fit, SaysWhichMethodItChoseAndWhy) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output fit = run(folder, {"fit", "quick.toml"});
  EXPECT_EQ(fit.exit, 0) << fit.err;
  EXPECT_TRUE(fit.err.starts_with("elastic (20 coordinates) with ")) << fit.err;
  EXPECT_EQ(parse_json(fit.out, "stdout").at("springs").list().size(), 20u);
}

// The default study runs in every build, and says what it has to leave out and how to get it.
TEST(DefaultStudy, RunsWithWhatThisBuildHas) {
  const Folder folder;
  const Output output =
      run(folder, {"compare", NODAL_SOURCE_DIR "/bench/scenes/plate.toml", "--repeats", "1", "--evaluations", "50"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_TRUE(contains(output.out, "annealing (baseline)") && contains(output.out, "random-search")) << output.out;
  const std::string no_nlopt =
      "multi-start L-BFGS: this build has no NLopt: install libnlopt-dev and libnlopt-cxx-dev and configure with "
      "-DNODAL_NLOPT=ON\n";
  const std::string no_ceres =
      "left out: ceres-levenberg-marquardt, ceres-dogleg: this build has no Ceres: install libceres-dev and configure "
      "with -DNODAL_CERES=ON\n";
  EXPECT_EQ(contains(output.err, no_nlopt), !NODAL_HAVE_NLOPT) << output.err;
  EXPECT_EQ(contains(output.err, no_ceres), !NODAL_HAVE_CERES) << output.err;
  // A row of the table begins with the label.
  EXPECT_EQ(contains(output.out, "\nnlopt-crs2-lm "), static_cast<bool>(NODAL_HAVE_NLOPT)) << output.out;
  EXPECT_EQ(contains(output.out, "\nceres-levenberg-marquardt "), static_cast<bool>(NODAL_HAVE_CERES)) << output.out;
}

TEST(Explain, ListsStagesUsedAndLeftOutAndTheTrials) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  const Output output = run(folder, {"explain", "quick.toml", "--trials"});
  EXPECT_EQ(output.exit, 0);
  EXPECT_TRUE(contains(output.out, "used     analytic reference")) << output.out;
  EXPECT_TRUE(contains(output.out, "left out measured reference")) << output.out;
  EXPECT_TRUE(contains(output.out, "4 trials; each ends after 300 evaluations")) << output.out;
  EXPECT_TRUE(contains(output.out, "elastic, random-search, 1")) << output.out;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

TEST(List, NamesWhatThisBuildHas) {
  const Folder folder;
  const Output optimizers = run(folder, {"list", "optimizers"});
  EXPECT_TRUE(contains(optimizers.out, "annealing: ")) << optimizers.out;
  EXPECT_TRUE(contains(optimizers.out,
                       "initial_temperature (number [quality at the start]; initial_temperature > 0; default 2e-04)"))
      << optimizers.out;
  EXPECT_TRUE(contains(run(folder, {"list", "problems"}).out, "elastic: "));
  const Output topologies = run(folder, {"list", "topologies"});
  for (const char* text : {"crossed: all diagonals", "none through the cells (in space only)\n",
                           "of a triangular grid (in the plane only)\n"})
    EXPECT_TRUE(contains(topologies.out, text)) << topologies.out;
  EXPECT_TRUE(contains(run(folder, {"list", "scenes"}).out, "plate.toml: The 25-node plate"));
}

TEST(Help, SaysWhatOnlyTakes) {
  const Folder folder;
  std::istringstream words(run(folder, {"compare", "--help"}).out);  // broken into lines somewhere
  std::string help;
  for (std::string word; words >> word;) help += word + " ";
  EXPECT_TRUE(contains(help, "with these labels, or with a 'use' that one entry has, separated by commas")) << help;
}

TEST(Help, IsThereForEveryCommand) {
  const Folder folder;
  EXPECT_EQ(run(folder, {"--help"}).exit, 0);
  for (const char* command : {"compare", "evaluate", "fit", "report", "export", "explain", "list", "init", "schema"}) {
    const Output output = run(folder, {command, "--help"});
    EXPECT_EQ(output.exit, 0) << command;
    EXPECT_TRUE(contains(output.out, "Usage: nodal " + std::string(command))) << output.out;
  }
}

TEST(Version, NamesTheRevisionAndTheLibraries) {
  const Folder folder;
  const Output output = run(folder, {"--version"});
  EXPECT_EQ(output.exit, 0);
  EXPECT_TRUE(output.out.starts_with("nodal 0.")) << output.out;
  EXPECT_TRUE(contains(output.out, "revision ") && contains(output.out, "CHOLMOD: ")) << output.out;
}

}  // namespace
}  // namespace nodal::program
