// SPDX-License-Identifier: GPL-3.0-or-later
#include "golden.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nodal/file.h>
#include <nodal/trial.h>

#include "../support/components.h"

namespace nodal::golden {
namespace {

class Golden : public testing::TestWithParam<Set> {
 protected:
  static std::vector<Value> read(const Set& set) {
    const std::string path = std::string(NODAL_TEST_DATA "/golden/") + file_of(set);
    std::vector<Value> lines;
    std::istringstream text(read_file(path, "golden record", kLargestInput));
    for (std::string line; std::getline(text, line);) lines.push_back(parse_json(line, path));
    return lines;
  }
  static const Value* find(const std::vector<Value>& lines, const Value& now) {
    for (const Value& line : lines)
      if (line.text_or("problem", "") == now.text_or("problem", "-") &&
          line.text_or("optimizer", "") == now.text_or("optimizer", "-"))
        return &line;
    return nullptr;
  }
};

void expect_same(const Value& golden, const Value& now) {
  for (const auto& [key, value] : golden.table()) {
    const Value* mine = now.find(key);
    ASSERT_NE(mine, nullptr) << key;
    EXPECT_EQ(to_json(*mine), to_json(value)) << key;
  }
  EXPECT_EQ(golden.table().size(), now.table().size()) << "fields";
}

void expect_near(const Value& golden, const Problem& problem) {
  const auto evaluator = problem.make_evaluator();
  const double start = golden.at("start").at("cost").number();
  EXPECT_NEAR(evaluator->audit(problem.space().start()).cost, start, 1e-9 * start);
  const Value* best = golden.find("best");
  if (best == nullptr || best->at("x").list().empty()) return;
  EXPECT_NEAR(evaluator->audit(best->at("x").numbers()).cost, best->at("cost").number(), 1e-9 * start);
}

TEST_P(Golden, RecordsAreWhatTheyWere) {
  const std::vector<Value> lines = read(GetParam());
  const bool here = to_json(lines.front()) == to_json(platform());
  const Study study = study_of(GetParam());
  for (const Trial& trial : all_trials(study)) {
    SCOPED_TRACE(study.problems[trial.problem].label + ", " + study.optimizers[trial.optimizer].label);
    Value name;
    name.set("problem", study.problems[trial.problem].label);
    name.set("optimizer", study.optimizers[trial.optimizer].label);
    const Value* golden = find(lines, name);
    ASSERT_NE(golden, nullptr);
    if (here) {
      expect_same(*golden, kept(run_trial(study, trial, components())));
    } else {
      expect_near(*golden, *study.problems[trial.problem].problem);
    }
  }
}

std::string name_of(const testing::TestParamInfo<Set>& info) {
  std::string name = info.param.scene;
  std::erase(name, '/');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(sets()), name_of);

}  // namespace
}  // namespace nodal::golden
