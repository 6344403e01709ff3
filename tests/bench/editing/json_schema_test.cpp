// SPDX-License-Identifier: GPL-3.0-or-later
// The schema that editors check studies by says what the reader of studies says.
#include <gtest/gtest.h>

#include <algorithm>

#include <editing/json_schema.h>
#include <nodal/file.h>
#include <nodal/study.h>
#include <nodal/toml.h>

#include "../../support/components.h"
#include "validate.h"

namespace nodal::editing {
namespace {

const Value& schema() {
  static const Value parsed = parse_json(study_json_schema(components()), "schema");
  return parsed;
}

std::string faults_of(const std::string& study) {
  std::string text;
  for (const std::string& fault : validate(schema(), parse_toml(study, "study"))) text += fault + "\n";
  return text;
}

// What is no study stands among them, too: nodal check's battery.
std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(NODAL_SOURCE_DIR "/bench/scenes"))
    if (entry.path().extension() == ".toml" && entry.path().filename() != "battery.toml") files.push_back(entry.path());
  return files;
}

TEST(JsonSchema, TakesEveryScene) {
  ASSERT_GT(scenes().size(), 20u);
  for (const std::filesystem::path& file : scenes()) EXPECT_EQ(faults_of(read_file(file, "scene")), "") << file;
}

TEST(JsonSchema, TakesTheSamplesOfEveryProblem) {
  for (const ProblemDescription& problem : components().problems())
    for (const ProblemSample& sample : problem.samples)
      EXPECT_EQ(faults_of("[problem]\nkind = \"" + problem.kind + "\"\n" + sample.settings), "")
          << problem.kind << " " << sample.name;
}

TEST(JsonSchema, TakesEveryMethodWithAllItsDefaults) {
  for (const OptimizerDescription& method : components().optimizers()) {
    Value entry, root;
    entry.set("use", method.name);
    entry.set("options", resolve_options(method.options, Value(), method.name).values());
    root.set("problem", Value::Table{{"kind", components().problems().front().kind}});
    root.set("optimizer", Value::List{entry});
    EXPECT_EQ(validate(schema(), root), std::vector<std::string>()) << method.name;
  }
}

// An editor marks the key that is wrong, not all that it stands in.
struct Wrong {
  const char *name, *study, *fault;
};
class WrongStudies : public testing::TestWithParam<Wrong> {};

TEST_P(WrongStudies, AreRefusedBySchemaAndReader) {
  const std::string study = GetParam().study;
  const std::string faults = faults_of(study);
  EXPECT_NE(faults.find(GetParam().fault), std::string::npos) << faults;
  EXPECT_THROW((void)parse_study(study, "study.toml", components()), InputError);
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongStudies,
    testing::Values(
        Wrong{"Table", "[studdy]\n[problem]\nkind = 'sphere'\n", "unknown key studdy"},
        Wrong{"NoProblem", "[study]\nseed = 1\n", "lacks problem"},
        Wrong{"Key", "[problem]\nkind = 'sphere'\n[study]\nseeed = 1\n", "/study: unknown key seeed"},
        Wrong{"Type", "[problem]\nkind = 'sphere'\n[study]\nseed = 'one'\n", "/study/seed: is no integer"},
        Wrong{"Range", "[problem]\nkind = 'sphere'\n[budget]\nseconds = 0\n", "/budget/seconds: is too small"},
        Wrong{"Choice", "[problem]\nkind = 'sphere'\n[study]\nstarts = 'random'\n", "/study/starts: is no choice"},
        Wrong{"Kind", "[problem]\nkind = 'sphare'\n", "/problem/kind: is no choice"},
        Wrong{"KindsKey", "[problem]\nkind = 'sphere'\npoisson = 0.2\n", "/problem: unknown key poisson"},
        Wrong{"DeepKey", "[problem]\nkind = 'elastic'\nmaterial = { poison = 0.2 }\n",
              "/problem/material: unknown key poison"},
        Wrong{"RangeOfAKind", "[problem]\nkind = { grid = ['sphere'] }\n", "/problem/kind: is no choice"},
        Wrong{"EmptyRange", "[problem]\nkind = 'sphere'\ndimension = { grid = [] }\n",
              "/problem/dimension: is nothing of"},
        Wrong{"Use", "[problem]\nkind = 'sphere'\n[[optimizer]]\nuse = 'anealing'\n",
              "/optimizer/0/use: is nothing of"},
        Wrong{"Option", "[problem]\nkind = 'sphere'\n[[optimizer]]\nuse = 'annealing'\noptions = { stepp = 1 }\n",
              "/optimizer/0/options: unknown key stepp"},
        Wrong{"LabelOfSeveral", "[problem]\nkind = 'sphere'\n[[optimizer]]\nuse = 'anneal*'\nlabel = 'a'\n",
              "/optimizer/0: unknown key label"}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

TEST(JsonSchema, TakesRangesPatternsAndIncludes) {
  EXPECT_EQ(faults_of("[[problem]]\nkind = 'elastic'\nmaterial = { poisson = { grid = [0.2, 0.3] } }\n"
                      "[[problem]]\nkind = 'elastic'\nlabel = 'b'\npoints = { counts = [{ count = 3, from = 4 }, 5] }\n"
                      "[[optimizer]]\nuse = 'anneal*'\n[[optimizer]]\nuse = 'annealing'\noptions = { step = { grid = "
                      "[0.1, 0.2] } }\n"),
            "");
  EXPECT_EQ(faults_of("include = ['common.toml']\n[problem]\nlabel = 'softer'\n"), "");
  EXPECT_NE(faults_of("include = 3\n[problem]\nkind = 'sphere'\n"), "");
}

// A library that this build lacks, and methods that no build has: any options.
TEST(JsonSchema, TakesMethodsThatAreLeftOut) {
  for (const AbsentDescription& absent : components().absent()) {
    std::string name = absent.name;
    if (name.ends_with('*')) name = name.substr(0, name.size() - 1) + "some";
    EXPECT_EQ(faults_of("[problem]\nkind = 'sphere'\n[[optimizer]]\nuse = '" + name + "'\noptions = { any = 1 }\n"), "")
        << name;
  }
}

TEST(JsonSchema, TellsWhatKeysMean) {
  const Value& elastic = schema().at("definitions").at("problem-elastic").at("properties");
  for (const Option& option : components().find_problem("elastic")->options) {
    ASSERT_TRUE(elastic.find(option.name)) << option.name;
    EXPECT_EQ(option.help.empty(), !elastic.at(option.name).find("description")) << option.name;
    EXPECT_EQ(option.default_value.has_value(), elastic.at(option.name).find("default") != nullptr) << option.name;
  }
}

}  // namespace
}  // namespace nodal::editing
