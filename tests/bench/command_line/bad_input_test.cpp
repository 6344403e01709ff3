// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input: one line on stderr that says what, where and what would be right; exit code 2; nothing written.
#include <gtest/gtest.h>

#include <string>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

// The plate with one line of it replaced.
std::string plate_with(const std::string& key, const std::string& line) {
  std::string text;
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"study", "[study]\nname = \"plate\"\nrepeats = 1\n"}, {"budget", "[budget]\nevaluations = 10\n"},
      {"problem", "[problem]\nkind = \"elastic\"\n"},        {"body", "body = { size = [4.0, 4.0] }\n"},
      {"material", "material = { poisson = 0.3 }\n"},        {"points", "points = { counts = [3, 3] }\n"},
      {"springs", "springs = { topology = \"crossed\" }\n"}, {"optimizer", "[[optimizer]]\nuse = \"annealing\"\n"},
  };
  for (const auto& [name, original] : lines) text += name == key ? line + "\n" : original;
  return text;
}

struct BadStudy {
  const char* name;
  const char* key;
  const char* line;
  const char* message;
};

class BadStudies : public testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, AreRefusedWithTheReason) {
  const Folder folder;
  folder.write("plate.toml", plate_with(GetParam().key, GetParam().line));
  const Output output = run(folder, {"compare", "plate.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, std::string("nodal: ") + GetParam().message + "\n");
  EXPECT_EQ(output.out, "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

const BadStudy kBadStudies[] = {
    {"UnknownTable", "budget", "[budgett]\nevaluations = 10",
     "plate.toml:4: unknown table or key 'budgett' in the study; did you mean 'budget'?"},
    {"UnknownKey", "material", "material = { poison = 0.3 }",
     "plate.toml:9: unknown key 'poison' in 'material' of problem 'elastic'; did you mean 'poisson'?"},
    {"WrongType", "material", "material = { poisson = \"soft\" }",
     "plate.toml:9: 'poisson' of 'material' of problem 'elastic' must be a number, not a text"},
    {"NotANumber", "material", "material = { young = nan }",
     "plate.toml:9: 'young' of 'material' of problem 'elastic' must be finite, not nan"},
    {"Infinite", "material", "material = { young = inf }",
     "plate.toml:9: 'young' of 'material' of problem 'elastic' must be finite, not inf"},
    {"NegativeSize", "body", "body = { size = [4.0, -4.0] }",
     "plate.toml:8: entry 2 of 'size' of 'body' of problem 'elastic' is -4; allowed: size > 0"},
    {"IncompressibleMaterial", "material", "material = { poisson = 0.5 }",
     "plate.toml:9: 'poisson' of 'material' of problem 'elastic' is 0.5; allowed: -1 < poisson < 0.5"},
    {"ImpossiblePoisson", "material", "material = { poisson = -1.0 }",
     "plate.toml:9: 'poisson' of 'material' of problem 'elastic' is -1; allowed: -1 < poisson < 0.5"},
    {"OneRow", "points", "points = { counts = [5, 1] }",
     "plate.toml:10: 'counts' is [5, 1]: a grid with one row or column has no area; give at least 2 nodes in each "
     "direction"},
    {"DefaultDensityOfNoMasses", "material", "masses = { density = 1.0 }",
     "plate.toml:9: 'density' in 'masses' belongs to form 'least-norm' or 'positive', and this one is 'none'"},
    {"DensityOfNoMasses", "material", "masses = { density = 1060 }",
     "plate.toml:9: 'density' in 'masses' belongs to form 'least-norm' or 'positive', and this one is 'none'"},
    {"ShareOfNoPositiveMasses", "material", "masses = { form = \"least-norm\", least_share = 0.5 }",
     "plate.toml:9: 'least_share' in 'masses' belongs to form 'positive', and this one is 'least-norm'"},
    {"TooLargeAGrid", "points", "points = { counts = [1000, 1001] }",
     "plate.toml:10: 'counts' is [1000, 1001]: more than 1000000 nodes"},
    {"UnknownOptimizer", "optimizer", "[[optimizer]]\nuse = \"anealing\"",
     "plate.toml:13: unknown optimizer 'anealing'; did you mean 'annealing'?"},
    {"UnknownKind", "problem", "[problem]\nkind = \"elastik\"",
     "plate.toml:7: unknown problem 'elastik'; did you mean 'elastic'?"},
    {"UnknownTopology", "springs", "springs = { topology = \"cross\" }",
     "plate.toml:11: unknown topology 'cross'; did you mean 'crossed'?"},
    {"Mechanism", "springs", "springs = { topology = \"grid\" }",
     "plate.toml:11: topology 'grid' is a mechanism: no diagonals, so its cells shear without resistance; take "
     "springs = { topology = \"crossed\" }, or \"single\" or \"alternating\""},
    {"TwoOptimizersOfOneLabel", "optimizer", "[[optimizer]]\nuse = \"annealing\"\n[[optimizer]]\nuse = \"annealing\"",
     "plate.toml:14: two optimizers have the label 'annealing' (the other is on line 12); give one a 'label' of its "
     "own"},
    {"ForeignOption", "optimizer", "[[optimizer]]\nuse = \"random-search\"\noptions = { step = 0.1 }",
     "plate.toml:14: unknown key 'step' in optimizer 'random-search'; it has no options"},
    {"NoBudget", "budget", "[budget]", "plate.toml: the study sets no budget; give [budget] seconds or evaluations"},
    {"NoOptimizer", "optimizer", "",
     "plate.toml: the study has no optimizer to compare; add an [[optimizer]] table, e.g. use = \"annealing\""},
    {"BadToml", "body", "body = { size = [4.0, 4.0 }",
     "plate.toml:8: not valid TOML: Error while parsing array: expected comma or closing ']', saw '}'"},
    {"EmptyLabel", "optimizer", "[[optimizer]]\nuse = \"annealing\"\nlabel = \"\"",
     "plate.toml:14: 'label' of [[optimizer]] is empty; it names rows and results"},
};
INSTANTIATE_TEST_SUITE_P(Studies, BadStudies, testing::ValuesIn(kBadStudies),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(BadStudy, WithoutAProblemIsRefused) {
  const Folder folder;
  folder.write("empty.toml", "[study]\nname = \"empty\"\n");
  const Output output = run(folder, {"compare", "empty.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: empty.toml: missing table [problem]; a study needs one\n");
}

// 79,398 residuals by 39,402 springs: refused when the study is read, before anything is allocated.
const std::string kLargePlate =
    "[budget]\nevaluations = 1\n[problem]\nkind = \"elastic\"\npoints = { counts = [100, 100] }\n";

TEST(BadStudy, WhoseDenseJacobianDoesntFitIsRefused) {
  const Folder folder;
  if (!NODAL_HAVE_CERES) GTEST_SKIP() << "no Ceres";
  folder.write("large.toml", kLargePlate + "[[optimizer]]\nuse = \"ceres-levenberg-marquardt\"\n");
  const Output output = run(folder, {"compare", "large.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(
      output.err.starts_with("nodal: large.toml:6: optimizer 'ceres-levenberg-marquardt' on problem 'elastic' "
                             "needs a dense Jacobian of 79398 × 39402 numbers, 23.3 GiB, where at most "))
      << output.err;
  EXPECT_NE(output.err.find("without one work: "), std::string::npos) << output.err;
  EXPECT_NE(output.err.find("gauss-newton"), std::string::npos) << output.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

TEST(BadStudy, WhoseDenseJacobianDoesntFitIsFittedWithoutOne) {
  const Folder folder;
  folder.write("large.toml", kLargePlate);
  const Output refused = run(folder, {"fit", "large.toml", "--with", "ceres-dogleg"});
  EXPECT_EQ(refused.exit, 2);
  const Output fit = run(folder, {"fit", "large.toml", "--export", "fit.json"});
  EXPECT_EQ(fit.exit, 0);
  EXPECT_TRUE(fit.err.starts_with("elastic (39402 coordinates) with gauss-newton: least squares by products"))
      << fit.err;
}

TEST(BadStudy, WithTwoProblemsOfOneLabelIsRefused) {
  const Folder folder;
  folder.write("two.toml", "[[problem]]\nkind = \"elastic\"\n[[problem]]\nkind = \"elastic\"\n");
  const Output output = run(folder, {"compare", "two.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err,
            "nodal: two.toml:3: two problems have the label 'elastic' (the other is on line 1); give one a 'label' of "
            "its own\n");
}

struct BadFile {
  const char* name;
  const char* springs;  ///< of a 2 × 2 grid, which has six springs
  const char* message;
};

class BadStiffnessFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadStiffnessFiles, AreRefusedWithTheReason) {
  const Folder folder;
  folder.write("plate.toml", plate_with("points", "points = { counts = [2, 2] }"));
  folder.write("k.json", GetParam().springs);
  const Output output = run(folder, {"evaluate", "plate.toml", "--stiffness", "k.json"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, std::string("nodal: ") + GetParam().message + "\n");
}

#define FIVE_SPRINGS                                                                                         \
  "{\"nodes\":[0,1],\"stiffness\":1},{\"nodes\":[2,3],\"stiffness\":1},{\"nodes\":[0,2],\"stiffness\":1},\n" \
  "{\"nodes\":[1,3],\"stiffness\":1},{\"nodes\":[0,3],\"stiffness\":1}"
const BadFile kBadFiles[] = {
    {"MissingSpring", "{\"springs\":[" FIVE_SPRINGS "]}",
     "k.json: spring (1, 2) is missing; every spring of the net must stand once"},
    {"DoubledSpring", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[3,0],\"stiffness\":1}]}",
     "k.json:3: spring (0, 3) stands twice; every spring must stand once"},
    {"UnknownSpring", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[1,7],\"stiffness\":1}]}",
     "k.json:3: spring (1, 7) is unknown: the net has no spring between these nodes"},
    {"NegativeStiffness", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[1,2],\"stiffness\":-1}]}",
     "k.json:3: spring (1, 2) has stiffness -1; it must be a positive number"},
    {"TextAsStiffness", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[1,2],\"stiffness\":\"one\"}]}",
     "k.json:3: \"stiffness\" must be a number, not a text"},
    {"NoStiffness", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[1,2]}]}",
     "k.json:3: spring (1, 2) has no \"stiffness\""},
    {"MisspeltStiffness", "{\"springs\":[" FIVE_SPRINGS ",\n{\"nodes\":[1,2],\"stifness\":1}]}",
     "k.json:3: unknown key 'stifness' in a spring; did you mean 'stiffness'?"},
    {"NoSprings", "{\"nodes\": []}",
     "k.json: a stiffness file must be {\"springs\": [{\"nodes\": [i, j], \"stiffness\": k}, …]}"},
    {"NoJson", "springs: none",
     "k.json:1: not valid JSON: syntax error while parsing value - invalid literal; last read: 's'"},
};
#undef FIVE_SPRINGS
INSTANTIATE_TEST_SUITE_P(Files, BadStiffnessFiles, testing::ValuesIn(kBadFiles),
                         [](const auto& row) { return std::string(row.param.name); });

struct BadCall {
  const char* name;
  std::vector<std::string> arguments;
  const char* message;
};

class BadCalls : public testing::TestWithParam<BadCall> {};

TEST_P(BadCalls, AreRefusedWithTheReason) {
  const Folder folder;
  folder.write("quick.toml", kQuickStudy);
  folder.write("a_file", "not a folder\n");
  const Output output = run(folder, GetParam().arguments);
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, std::string("nodal: ") + GetParam().message + "\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

const BadCall kBadCalls[] = {
    {"NoCommand",
     {},
     "no command given; valid: 'compare', 'evaluate', 'fit', 'report', 'merge', 'verify', 'export', 'explain', "
     "'trials', 'check', 'list', 'init' and 1 more; see nodal "
     "--help"},
    {"UnknownCommand", {"compair", "quick.toml"}, "'compair' is no command; did you mean 'compare'?"},
    {"UnknownOption",
     {"compare", "quick.toml", "--repeat", "3"},
     "'--repeat' is no option of nodal compare; did you mean '--repeats'?"},
    {"NoStudy", {"compare"}, "study is required; see nodal compare --help"},
    {"MissingStudy", {"compare", "other.toml"}, "cannot read study 'other.toml': No such file or directory"},
    {"FolderAsStudy", {"compare", "."}, "cannot read study '.': Is a directory"},
    {"UnknownLabel",
     {"compare", "quick.toml", "--only", "anneling"},
     "--only: no optimizer of the study is labelled 'anneling'; did you mean 'annealing'?"},
    {"EmptyOnly",
     {"compare", "quick.toml", "--only", ""},
     "--only: no optimizer of the study is labelled ''; valid: 'annealing', 'random-search'"},
    {"EmptyRerun",
     {"compare", "quick.toml", "--rerun", ""},
     "--rerun: no optimizer of the study is labelled ''; valid: 'annealing', 'random-search'"},
    {"EmptyShard", {"compare", "quick.toml", "--shard", ""}, "--shard: is empty; see nodal compare --help"},
    {"EmptyTrials", {"compare", "quick.toml", "--trials", ""}, "--trials: is empty; see nodal compare --help"},
    {"EmptyOut", {"compare", "quick.toml", "--out", ""}, "--out: is empty; see nodal compare --help"},
    {"EmptyExport", {"fit", "quick.toml", "--export", ""}, "--export: is empty; see nodal fit --help"},
    {"NegativeSeed",
     {"compare", "quick.toml", "--seed", "-1"},
     "--seed: '-1' is no whole number from 0 to 9223372036854775807; see nodal compare --help"},
    {"SeedThatNoFileHolds",
     {"trials", "quick.toml", "--seed", "18446744073709551615"},
     "--seed: '18446744073709551615' is no whole number from 0 to 9223372036854775807; see nodal trials --help"},
    {"TooManyEvaluations",
     {"compare", "quick.toml", "--evaluations", "99999999999999999999"},
     "--evaluations: '99999999999999999999' is no whole number from 1 to 9223372036854775807; see nodal compare "
     "--help"},
    {"NegativeSeedOfVerify",
     {"verify", "results/quick", "--seed", "-1"},
     "--seed: '-1' is no whole number from 0 to 9223372036854775807; see nodal verify --help"},
    {"TooManyTrialsToVerify",
     {"verify", "results/quick", "--trials", "99999999999999999999"},
     "--trials: '99999999999999999999' is no whole number from 1 to 9223372036854775807; see nodal verify --help"},
    {"TooManyRepeats",
     {"compare", "quick.toml", "--repeats", "100001"},
     "--repeats: is 100001; allowed: 1 ≤ repeats ≤ 100000"},
    {"TooManyRepeatsToExplain",
     {"explain", "quick.toml", "--repeats", "2147483647"},
     "--repeats: is 2147483647; allowed: 1 ≤ repeats ≤ 100000"},
    {"PruneLossThatIsNoNumber",
     {"fit", "quick.toml", "--prune", "--prune-loss", "nan"},
     "--prune-loss: 'nan' is no number from 0 on; see nodal fit --help"},
    {"NegativePruneLoss",
     {"fit", "quick.toml", "--prune", "--prune-loss", "-1"},
     "--prune-loss: '-1' is no number from 0 on; see nodal fit --help"},
    {"NegativeSeconds",
     {"compare", "quick.toml", "--seconds", "-1"},
     "--seconds: '-1' is no number above 0; see nodal compare --help"},
    {"ZeroRepeats",
     {"compare", "quick.toml", "--repeats", "0"},
     "--repeats: '0' is no number above 0; see nodal compare --help"},
    {"FileAsStore",
     {"compare", "quick.toml", "--out", "a_file"},
     "cannot write 'a_file': Not a directory; what was stored before stays valid"},
    {"NoStore",
     {"report", "nowhere"},
     "'nowhere' is not a store: it has no manifest.json; give the directory that nodal compare wrote"},
    {"UnknownProblem",
     {"evaluate", "quick.toml", "--problem", "plates"},
     "--problem: no problem of the study is labelled 'plates'; valid: 'elastic'"},
    {"UnknownMethod",
     {"fit", "quick.toml", "--with", "anneal"},
     "--with: 'anneal' is neither a label of the study nor an optimizer; did you mean 'annealing' or "
     "'annealing-adaptive'?"},
    {"UnwritableExport",
     {"fit", "quick.toml", "--export", "no/where/fit.json"},
     "--export: cannot write 'no/where/fit.json': there is no folder 'no/where'; give a file in a folder that exists "
     "and may be written"},
    {"UnwritablePicture",
     {"fit", "quick.toml", "--picture", "no/where/fit.svg"},
     "--picture: cannot write 'no/where/fit.svg': there is no folder 'no/where'; give a file in a folder that exists "
     "and may be written"},
    {"UnwritablePictureOfTheStart",
     {"evaluate", "quick.toml", "--picture", "a_file/start.svg"},
     "--picture: cannot write 'a_file/start.svg': there is no folder 'a_file'; give a file in a folder that exists and "
     "may be written"},
    {"PictureOverTheStudy",
     {"evaluate", "quick.toml", "--picture", "quick.toml"},
     "--picture: 'quick.toml' doesn't end in .svg; pictures are SVG files, e.g. plate.svg"},
    {"PictureOfAnotherKind",
     {"fit", "quick.toml", "--picture", "fit.png"},
     "--picture: 'fit.png' doesn't end in .svg; pictures are SVG files, e.g. plate.svg"},
    {"TablesAsStudy",
     {"report", "results/quick", "--latex", "quick.toml"},
     "--latex: 'quick.toml' doesn't end in .tex; tables are a LaTeX file, e.g. tables.tex"},
    {"UnknownList",
     {"list", "tables"},
     "what: tables not in {optimizers,problems,topologies,scenes}; see nodal list --help"},
};
INSTANTIATE_TEST_SUITE_P(Calls, BadCalls, testing::ValuesIn(kBadCalls),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(BadStart, OutsideTheBoundsIsRefused) {
  const Folder folder;
  folder.write("plate.toml", plate_with("springs", "springs = { initial = { file = \"k.json\" } }"));
  folder.write("plain.toml", plate_with("", ""));
  const Output fitted = run(folder, {"fit", "plain.toml", "--with", "random-search", "--export", "k.json"});
  ASSERT_EQ(fitted.exit, 0) << fitted.err;
  std::string text = read_file(folder.path() / "k.json");
  const std::size_t at = text.find("\"stiffness\":") + 12;
  text.replace(at, text.find_first_of(",}", at) - at, "1000");
  folder.write("k.json", text);
  const Output output = run(folder, {"compare", "plate.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err,
            "nodal: plate.toml:11: the start's spring (0, 1) has stiffness 1000, outside the bounds [0.0001, 100] "
            "([0.0001, 100] × young × thickness); change the file or springs = { bounds = … }\n");
}

}  // namespace
}  // namespace nodal::program
