// SPDX-License-Identifier: GPL-3.0-or-later
// `best_known = { file = … }`: the system that is the best known, evaluated, gaps measured against it, shown.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <nodal/value.h>

#include "program.h"
#include "studies.h"

namespace nodal::program {
namespace {

const std::string kFile = "best_known = { file = \"best.json\", origin = \"a fit\" }\n";

// The quick study with something more in its problem.
std::string study_with(const std::string& line) {
  std::string text = kQuickStudy;
  return text.insert(text.find("points = "), line);
}

// Fits the study with `line` in its problem, and writes best.json.
void write_best(const Folder& folder, const std::string& line = "") {
  folder.write("fit.toml", study_with(line));
  const Output fitted = run(folder, {"fit", "fit.toml", "--with", "gauss-newton", "--export", "best.json"});
  ASSERT_EQ(fitted.exit, 0) << fitted.err;
}

std::string refusal(const Folder& folder, const std::string& line) {
  folder.write("s.toml", study_with(line));
  const Output output = run(folder, {"explain", "s.toml"});
  EXPECT_EQ(output.exit, 2);
  return output.err;
}

TEST(BestKnown, OfAFileIsEvaluatedAndShown) {
  const Folder folder;
  write_best(folder);
  const Value evaluated =
      parse_json(run(folder, {"evaluate", "fit.toml", "--stiffness", "best.json", "--json"}).out, "evaluated");
  folder.write("s.toml", study_with(kFile));
  const Output explained = run(folder, {"explain", "s.toml"});
  EXPECT_EQ(explained.exit, 0) << explained.err;
  const std::string said = fmt::format("best known: quality {:.10g} (a fit)", evaluated.at("quality").number());
  EXPECT_TRUE(contains(explained.out, said)) << said << '\n' << explained.out;

  ASSERT_EQ(run(folder, {"compare", "s.toml"}).exit, 0);
  const Value manifest = parse_json(read_file(folder.path() / "results/quick/manifest.json"), "manifest");
  EXPECT_EQ(manifest.at("problems").list()[0].at("best_known").at("x").list().size(), 20u);
  const std::string page = read_file(folder.path() / "results/quick/report.html");
  EXPECT_TRUE(contains(page, "Of the best known G that was given"));
  EXPECT_TRUE(contains(page, "digits hold in arithmetic of 50 at its point"));
  EXPECT_TRUE(contains(page, ">best known, as given<")) << "no picture of it";
}

TEST(BestKnown, IsAQualityOrAFile) {
  const Folder folder;
  EXPECT_EQ(refusal(folder, "best_known = { origin = \"x\" }\n"),
            "nodal: s.toml:10: 'best_known' has either a 'quality', or a 'file' with the system that has it\n");
  EXPECT_TRUE(contains(refusal(folder, "best_known = { quality = 1, file = \"best.json\", origin = \"x\" }\n"),
                       "s.toml:10: 'best_known' has either"));
  EXPECT_TRUE(contains(refusal(folder, kFile), "nodal: s.toml:10: cannot read stiffness file"));
}

// Of what is included, of the study, and of --set the last counts.
TEST(BestKnown, OfTwoWaysTheLaterOneCounts) {
  const Folder folder;
  write_best(folder);
  folder.write("number.toml", study_with("best_known = { quality = 0.5, origin = \"a guess\" }\n"));
  folder.write("file.toml", "include = \"number.toml\"\n[problem]\n" + kFile);
  const Output file = run(folder, {"explain", "file.toml"});
  EXPECT_TRUE(contains(file.out, "(a fit)")) << file.err;
  const Output number = run(folder, {"explain", "file.toml", "--set", "problem.best_known.quality=0.25"});
  EXPECT_TRUE(contains(number.out, "best known: quality 0.25 (a fit)")) << number.err;
  const Output again = run(folder, {"explain", "number.toml", "--set", "problem.best_known.file=\"best.json\""});
  EXPECT_TRUE(contains(again.out, "(a guess)")) << again.err;
  EXPECT_FALSE(contains(again.out, "quality 0.5 (")) << again.out;
}

// The study that names a file is fitted to write it; a page that is made again has the point from the store.
TEST(BestKnown, IsReadWhereItIsNeeded) {
  const Folder folder;
  folder.write("s.toml", study_with(kFile));
  const Output fitted = run(folder, {"fit", "s.toml", "--with", "gauss-newton", "--export", "best.json"});
  ASSERT_EQ(fitted.exit, 0) << fitted.err;
  ASSERT_EQ(run(folder, {"compare", "s.toml"}).exit, 0);
  std::filesystem::remove(folder.path() / "best.json");
  const Output report = run(folder, {"report", "results/quick"});
  EXPECT_EQ(report.exit, 0) << report.err;
  EXPECT_TRUE(contains(read_file(folder.path() / "results/quick/report.html"), ">best known, as given<")) << report.err;
  EXPECT_EQ(run(folder, {"compare", "s.toml"}).exit, 2);
}

// A quality that no point of the space has would be a gap that nobody can close.
TEST(BestKnown, MustBeWithinReach) {
  const Folder folder;
  write_best(folder);
  for (const char* line : {"springs = { parameters = \"uniform\" }\n", "springs = { bounds = [3, 4] }\n"})
    EXPECT_TRUE(contains(refusal(folder, kFile + line), "is not a system that this problem can reach")) << line;
}

TEST(BestKnown, OfAProblemThatReadsNoFilesIsAQuality) {
  const Folder folder;
  folder.write("s.toml", "[study]\nname = \"s\"\n[budget]\nevaluations = 9\n[problem]\nkind = \"sphere\"\n" + kFile +
                             "[[optimizer]]\nuse = \"random-search\"\n");
  const Output output = run(folder, {"explain", "s.toml"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_EQ(output.err, "nodal: s.toml:7: this problem reads no values from a file; give the 'quality' instead\n");
}

}  // namespace
}  // namespace nodal::program
