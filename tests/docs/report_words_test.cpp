// SPDX-License-Identifier: GPL-3.0-or-later
// docs/reading_a_report.md explains every word that a report, a record or a manifest uses.
#include <gtest/gtest.h>

#include <set>

#include <nodal/store.h>
#include <nodal/study.h>
#include <nodal/trial.h>

#include <report/report.h>
#include <report/table.h>

#include "../bench/report/fixture.h"
#include "../lib/toy_record.h"
#include "../support/components.h"
#include "../support/temporary_directory.h"
#include "pages.h"

namespace nodal::docs {
namespace {

const std::string& page() {
  static const std::string text = read_page("reading_a_report.md");
  return text;
}

void expect_explained(const std::string& word, const std::string& where) {
  EXPECT_NE(page().find("`" + word + "`"), std::string::npos)
      << "docs/reading_a_report.md has no `" << word << "`, which is " << where;
}

// Every key of a table and of the tables in it, but not what stands below `owned`: those keys are others' own.
void expect_keys_explained(const Value& value, const std::set<std::string>& owned, const std::string& where) {
  if (value.is_list())
    for (const Value& item : value.list()) expect_keys_explained(item, owned, where);
  if (!value.is_table()) return;
  for (const auto& [key, entry] : value.table()) {
    expect_explained(key, "a field of " + where);
    if (!owned.contains(key)) expect_keys_explained(entry, owned, where);
  }
}

Study small_study(const Registry& registry) {
  return parse_study(R"(
[study]
name = "words"
repeats = 1
[budget]
evaluations = 20
[problem]
kind = "elastic"
points = { counts = [3, 3] }
best_known = { quality = 0.1, origin = "a guess" }
[[optimizer]]
use = "annealing"
baseline = true
[[optimizer]]
use = "random-search"
)",
                     "words.toml", registry);
}

TEST(ReadingAReport, ExplainsEveryFieldOfARecord) {
  const Study study = small_study(components());
  for (const Trial& trial : all_trials(study)) {
    const TrialRecord record = run_trial(study, trial, components());
    ASSERT_EQ(record.end, End::budget) << record.reason;
    expect_keys_explained(parse_json(to_json_line(record), "record"), {"options"}, "a trial's record");
  }
  // Fields that such trials leave empty.
  expect_keys_explained(parse_json(to_json_line(toy::full_record()), "record"), {"options"}, "a trial's record");
}

TEST(ReadingAReport, ExplainsEveryEnd) {
  for (int end = 0; end <= static_cast<int>(End::crashed); ++end)
    expect_explained(std::string(to_string(static_cast<End>(end))), "an end of a trial");
}

TEST(ReadingAReport, ExplainsEveryColumnOfTheCsv) {
  const report::ReportData nothing;
  int columns = 0;
  for (const auto& [file, text] : {std::pair("summary.csv", report::summary_csv(nothing)),
                                   {"optimizers.csv", report::optimizers_csv(nothing)},
                                   {"budgets.csv", report::budgets_csv(nothing)}}) {
    std::istringstream header(text);
    for (std::string name; std::getline(header, name, ','); ++columns) {
      if (name.ends_with('\n')) name.pop_back();
      expect_explained(name, std::string("a column of ") + file);
    }
  }
  EXPECT_GT(columns, 60);
}

TEST(ReadingAReport, ExplainsEveryColumnOfTheTable) {
  report::ProblemReport problem = report::fixture::make_problem();
  const auto expect_columns_explained = [&problem] {
    for (const report::Column& column : report::make_text_table(problem).columns) {
      std::string name = column.title;
      if (name.ends_with('-'))
        name.pop_back();  // "evalu-", "ations"
      else if (!name.empty() && !column.subtitle.empty())
        name += ' ';
      expect_explained(name + column.subtitle, "a column of the table");
    }
  };
  expect_columns_explained();
  for (OptimizerRow& row : problem.table.rows) row.relative_error.reset();
  expect_columns_explained();
}

TEST(ReadingAReport, ExplainsEveryFieldOfTheManifest) {
  toy::TemporaryDirectory directory;
  Study study = small_study(components());
  study.left_out = {{"lost", "nlopt-mma", "not in this build"}};
  Store store(directory.path());
  store.begin(study);
  expect_keys_explained(store.manifest(), {"options", "libraries", "environment"}, "manifest.json");
}

}  // namespace
}  // namespace nodal::docs
