// SPDX-License-Identifier: GPL-3.0-or-later
// A study to begin with is a study, whatever is registered.
#include <gtest/gtest.h>

#include <sstream>

#include <editing/json_schema.h>
#include <editing/study_template.h>
#include <nodal/study.h>
#include <nodal/toml.h>
#include <nodal/trial.h>

#include "../../support/components.h"
#include "../../support/messages.h"
#include "validate.h"

namespace nodal::editing {
namespace {

Study read(const std::string& text) { return parse_study(text, "study.toml", components()); }

TEST(StudyTemplate, OfEveryProblemReads) {
  for (const ProblemDescription& problem : components().problems()) {
    const Study study = read(study_template({problem.kind, {}}, components()));
    ASSERT_EQ(study.problems.size(), 1u) << problem.kind;
    EXPECT_EQ(study.problems[0].kind, problem.kind);
    ASSERT_FALSE(study.optimizers.empty()) << problem.kind;
    EXPECT_TRUE(study.optimizers[0].baseline);
    EXPECT_FALSE(all_trials(study).empty());
    EXPECT_TRUE(study.budget.seconds && study.budget.evaluations);
  }
}

TEST(StudyTemplate, OfEveryMethodReads) {
  for (const OptimizerDescription& method : components().optimizers()) {
    const Study study = read(study_template({"elastic", {method.name}}, components()));
    ASSERT_EQ(study.optimizers.size(), 1u) << method.name;
    EXPECT_EQ(study.optimizers[0].use, method.name);
  }
}

void expect_keys(const std::string& text, const OptionSchema& schema, const std::string& path) {
  for (const Option& option : schema) {
    EXPECT_NE(text.find(path + option.name), std::string::npos) << path << option.name;
    expect_keys(text, option.fields, path + option.name + ".");
  }
}

TEST(StudyTemplate, HasEveryKey) {
  const std::string text = study_template({"elastic", {"annealing"}}, components());
  expect_keys(text, study_schema(), "");
  expect_keys(text, budget_schema(), "");
  expect_keys(text, problem_entry_schema(), "");
  expect_keys(text, components().find_problem("elastic")->options, "");
  expect_keys(text, components().find_optimizer("annealing")->options, "options.");
}

// Every default, one after the other: what is behind the '#' is what holds without it.
TEST(StudyTemplate, HasDefaultsThatMayStandThere) {
  for (const std::string kind : {"sphere", "elastic"}) {
    std::istringstream lines(study_template({kind, {"annealing"}}, components()));
    int defaults = 0;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = line.find(" = ");
      if (!line.starts_with("# ") || line.starts_with("#  ") || equals == std::string::npos) continue;
      if (line.substr(2, equals - 2).find_first_of(" :") != std::string::npos) continue;
      EXPECT_NO_THROW((void)parse_toml(line.substr(2), line)) << line;
      ++defaults;
    }
    EXPECT_GT(defaults, 10) << kind;
  }
}

TEST(StudyTemplate, MeansTheSameWithItsDefaults) {
  const std::string text = study_template({"sphere", {"annealing"}}, components());
  std::istringstream lines(text);
  std::string filled;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    const bool is_default = line.starts_with("# ") && !line.starts_with("#  ") && equals != std::string::npos &&
                            line.substr(2, equals - 2).find_first_of(" :") == std::string::npos;
    filled += (is_default ? line.substr(2) : line) + "\n";
  }
  ASSERT_NE(filled, text);
  const Study bare = read(text), full = read(filled);
  EXPECT_EQ(trial_key(bare, {}), trial_key(full, {})) << filled;
}

TEST(StudyTemplate, IsWhatTheSchemaOfEditorsTakes) {
  const Value schema = parse_json(study_json_schema(components()), "schema");
  for (const ProblemDescription& problem : components().problems())
    EXPECT_EQ(validate(schema, parse_toml(study_template({problem.kind, {}}, components()), "study")),
              std::vector<std::string>())
        << problem.kind;
}

TEST(StudyTemplate, IsOfTheProblemWithTheMostKeysUnlessSaid) {
  EXPECT_EQ(read(study_template({}, components())).problems[0].kind, "elastic");
}

TEST(StudyTemplate, RefusesWhatIsNotThere) {
  const auto message = [](const TemplateRequest& request) {
    return toy::message_of([&] { (void)study_template(request, components()); });
  };
  EXPECT_EQ(message({"elastik", {}}).substr(0, 50), "--problem: unknown problem 'elastik'; did you mean");
  EXPECT_EQ(message({"sphere", {"anealing"}}).substr(0, 42), "--optimizer: unknown optimizer 'anealing';");
}

}  // namespace
}  // namespace nodal::editing
