// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/report_data.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <report/page_parts.h>
#include <report/report.h>
#include <report/table.h>

namespace nodal::report {
namespace {

// One kind, whose details are shown as they are.
const Registry& kinds() {
  static const Registry registry = [] {
    Registry made;
    made.add(ProblemDescription{.kind = "elastic",
                                .quality_name = "G",
                                .findings = {{.name = "spread", .title = "k_max/k_min"}},
                                .show_details = [](const Value& details) {
                                  return ReportPart{to_json(details), "", ""};
                                }});
    return made;
  }();
  return registry;
}

// A store on disk, written as files: collecting needs no study.
class Collect : public ::testing::Test {
 protected:
  Collect()
      : folder_(std::filesystem::temp_directory_path() /
                ("nodal_collect_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
                 std::to_string(::getpid()))) {}
  ~Collect() override { std::filesystem::remove_all(folder_); }

  static TrialRecord record(const std::string& key, const std::string& optimizer, double quality,
                            End end = End::budget) {
    TrialRecord r;
    r.key = key;
    r.problem = "plate";
    r.optimizer = r.use = optimizer;
    r.end = end;
    r.reason = end == End::budget ? "evaluations spent" : "the plate broke";
    r.start = {0.5, 4.0, 1.0};
    r.best = BestPoint{10, {0.5 * quality * quality / 16.0, quality, quality / 4.0}, {0.1, 0.2}};
    r.counts.evaluations = 10;
    r.seconds.total = 0.5;
    r.trace = {{0, 1e-4, 0, 4.0}, {10, 0.1, 4, quality}};
    return r;
  }

  // `young` makes problems differ; no keys: everything counts.
  Store store(const std::string& name, const std::vector<TrialRecord>& records, double young = 1.0,
              const Value::List& keys = {}, const Value& details = {}, const std::string& inputs = "") const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path / "trials");
    Value problem, optimizer, study, manifest, options;
    options.set("young", young);
    problem.set("label", "plate");
    problem.set("kind", "elastic");
    problem.set("options", options);
    if (!details.table().empty()) problem.set("details", details);
    if (!inputs.empty()) problem.set("inputs", inputs);
    optimizer.set("label", records.at(0).optimizer);
    optimizer.set("use", records.at(0).use);
    optimizer.set("baseline", records.at(0).optimizer == "annealing");
    study.set("name", "race");
    study.set("text", "[study]\n");
    manifest.set("schema", 1);
    manifest.set("study", study);
    manifest.set("problems", Value::List{problem});
    manifest.set("optimizers", Value::List{optimizer});
    manifest.set("left_out", Value::List{});
    manifest.set("keys", keys);
    manifest.set("runs", Value::List{});
    std::ofstream(path / "manifest.json") << to_json(manifest);
    std::ofstream lines(path / "trials" / "one.jsonl");
    for (const TrialRecord& r : records) lines << to_json_line(r) << '\n';
    lines.close();
    return Store::open_existing(path);
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(Collect, MergesStoresAndCountsARecordOnce) {
  std::vector<Store> stores;
  stores.push_back(store("a", {record("k1", "annealing", 2.0), record("k2", "annealing", 2.2)}));
  stores.push_back(store("b", {record("k3", "ceres", 1.0), record("k1", "annealing", 2.0)}));
  const ReportData data = collect(stores, kinds());
  EXPECT_EQ(data.study_name, "race");
  ASSERT_EQ(data.problems.size(), 1u);
  const ProblemReport& problem = data.problems[0];
  ASSERT_EQ(problem.table.rows.size(), 2u);
  EXPECT_EQ(problem.table.rows[0].label, "annealing");
  EXPECT_TRUE(problem.table.rows[0].baseline);
  EXPECT_EQ(problem.table.rows[0].trials, 2u);
  EXPECT_EQ(problem.table.rows[1].trials, 1u);
  EXPECT_TRUE(problem.table.reference.provisional);
  ASSERT_TRUE(problem.best);
  EXPECT_EQ(problem.best->optimizer, "ceres");
  ASSERT_TRUE(problem.error_per_quality);
  EXPECT_DOUBLE_EQ(*problem.error_per_quality, 0.25);
  EXPECT_EQ(problem.curves.size(), 2u);
  EXPECT_TRUE(data.warnings.empty());
}

TEST_F(Collect, LeavesOutTrialsOfEarlierSettingsAndSaysSo) {
  std::vector<Store> stores;
  stores.push_back(store("a", {record("k1", "annealing", 2.0), record("old", "annealing", 1.0)}, 1.0, {"k1"}));
  const ReportData data = collect(stores, kinds());
  EXPECT_EQ(data.problems[0].table.rows[0].trials, 1u);
  ASSERT_EQ(data.warnings.size(), 1u);
  EXPECT_NE(data.warnings[0].find("1 stored trials"), std::string::npos);
}

TEST_F(Collect, RefusesDifferentProblemsUnderOneLabel) {
  std::vector<Store> stores;
  stores.push_back(store("a", {record("k1", "annealing", 2.0)}, 1.0));
  stores.push_back(store("b", {record("k2", "annealing", 2.0)}, 2.0));
  EXPECT_THROW((void)collect(stores, kinds()), InputError);
}

// A table without rows beside others would look like a result.
TEST_F(Collect, LeavesOutProblemsThatNobodyTriedAndSaysSo) {
  TrialRecord other = record("k1", "annealing", 2.0);
  other.problem = "gear";
  std::vector<Store> stores;
  stores.push_back(store("a", {other}));
  const ReportData data = collect(stores, kinds());
  ASSERT_EQ(data.problems.size(), 1u);
  EXPECT_EQ(data.problems[0].table.reference.label, "gear");
  ASSERT_EQ(data.warnings.size(), 1u);
  EXPECT_EQ(data.warnings[0], "no trial of problem 'plate' is stored yet");
}

TEST_F(Collect, FindsEntriesThatAreOneAndClaimsThatNobodySaw) {
  std::vector<TrialRecord> records = {record("k1", "annealing", 2.0), record("k2", "my annealing", 2.0)};
  for (TrialRecord& r : records)
    r.trace = {{0, 1e-4, 0, 4.0}, {1, 0.1, 0, 3.5},  {3, 0.1, 0, 3.0},
               {5, 0.1, 0, 2.5},  {7, 0.1, 0, 2.25}, {9, 0.1, 0, 2.0}};
  records[1].claimed = ClaimRecord{0.25 * *records[1].best->summary.cost, {}, {}, "done"};
  std::vector<Store> stores;
  stores.push_back(store("a", records));
  const Scrutiny found = collect(stores, kinds()).problems.at(0).scrutiny;
  ASSERT_EQ(found.aliases.size(), 1u);
  EXPECT_EQ(found.aliases[0].second, "my annealing");
  ASSERT_EQ(found.optimizers.size(), 2u);
  EXPECT_TRUE(found.optimizers[0].claims.agrees());
  EXPECT_EQ(found.optimizers[1].claims.better.trials, 1u);
}

TEST_F(Collect, KeepsTheReasonsOfFailedTrials) {
  std::vector<Store> stores;
  stores.push_back(store("a", {record("k1", "annealing", 2.0), record("k2", "annealing", 3.0, End::crashed)}));
  const ReportData data = collect(stores, kinds());
  ASSERT_EQ(data.failed.size(), 1u);
  EXPECT_EQ(data.failed[0].end, End::crashed);
  EXPECT_EQ(data.failed[0].reason, "the plate broke");
}

// With a prior the race is one for "G with prior": curves are of it, and never relabelled as relative errors, though
// these are proportional to G in every record.
TEST_F(Collect, TellsThePriorsShareApart) {
  TrialRecord wished = record("k1", "annealing", 2.0);
  wished.start.data_quality = 4.0;
  wished.best->summary.data_quality = 1.5;
  wished.best->summary.relative_error = 1.5 / 4.0;
  std::vector<Store> stores;
  stores.push_back(store("a", {wished}));
  const ReportData data = collect(stores, kinds());
  const ProblemReport& problem = data.problems[0];
  EXPECT_TRUE(problem.table.has_prior);
  EXPECT_FALSE(problem.error_per_quality);
  EXPECT_EQ(problem.raced_name(), "G with prior");
  EXPECT_DOUBLE_EQ(problem.table.reference.best_quality, 2.0);
  EXPECT_DOUBLE_EQ(problem.table.rows[0].quality->median, 2.0);
  EXPECT_DOUBLE_EQ(problem.table.rows[0].data_quality->median, 1.5);

  const Table table = make_text_table(problem);
  std::vector<std::string> shown;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].subtitle == "median") shown.push_back(table.rows[0][c]);
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown[0], "1.500");  // beside the relative error, and of the same part
  EXPECT_TRUE(describe_reference(problem).starts_with(problem.raced_name() +
                                                      " at the start 4.000 (relative error without it 1.000); " +
                                                      problem.raced_name() + "* = 2.000,"))
      << describe_reference(problem);
  EXPECT_NE(table_legend(data.problems).back().find("With a prior"), std::string::npos);
  const std::string chart = chart_html(problem, 0);
  EXPECT_NE(chart.find("\"title\":\"" + problem.raced_name() + "\""), std::string::npos);
  EXPECT_EQ(chart.find("errorPerQuality"), std::string::npos);
  EXPECT_EQ(chart.find("relative error"), std::string::npos);
  const std::string csv = optimizers_csv(data);
  EXPECT_NE(csv.find(",data_quality_lower,data_quality_median,data_quality_upper"), std::string::npos);
  EXPECT_NE(csv.find(",1.5,1.5,1.5"), std::string::npos);
}

TEST_F(Collect, DrawsQualityWhereErrorIsNotProportionalToIt) {
  TrialRecord odd = record("k1", "annealing", 2.0);
  odd.best->summary.relative_error = 0.1;
  std::vector<Store> stores;
  stores.push_back(store("a", {odd}));
  EXPECT_FALSE(collect(stores, kinds()).problems[0].error_per_quality);
}

TEST_F(Collect, TakesDetailsFromTheFirstStoreThatHasThem) {
  const auto details = [](std::int64_t rank) {
    Value masses, table;
    masses.set("rank", Value(rank));
    table.set("masses", masses);
    return table;
  };
  std::vector<Store> stores;
  stores.push_back(store("a", {record("k1", "annealing", 2.0)}));
  stores.push_back(store("b", {record("k2", "annealing", 2.0)}, 1.0, {}, details(6)));
  stores.push_back(store("c", {record("k3", "annealing", 2.0)}, 1.0, {}, details(5)));
  const ReportData data = collect(stores, kinds());
  ASSERT_EQ(data.problems.size(), 1u);
  EXPECT_EQ(data.problems[0].details.html, R"({"masses":{"rank":6}})");
}

TEST_F(Collect, KnowsWhatTheKindCallsThings) {
  TrialRecord found = record("k1", "annealing", 2.0);
  found.health.findings = {{"spread", 12.0}, {"sag", 0.5}, {"unseen", 0.1}};
  std::vector<Store> stores;
  stores.push_back(store("a", {found, record("k2", "annealing", 2.0)}));
  const ReportData data = collect(stores, kinds());
  EXPECT_EQ(data.problems[0].quality_name, "G");
  // Of a finding that the kind doesn't describe there is its name.
  ASSERT_EQ(data.problems[0].findings.size(), 3u);
  EXPECT_EQ(data.problems[0].findings[0].title, "k_max/k_min");
  EXPECT_EQ(data.problems[0].findings[1].title, "sag");
  EXPECT_EQ(data.problems[0].findings[2].help, unseen_finding().help);
  EXPECT_EQ(data.problems[0].table.rows[0].findings.at("spread").median, 12.0);
  EXPECT_EQ(collect(stores, Registry()).problems[0].quality_name, "quality");
}

TEST_F(Collect, RefusesOtherFilesUnderOneLabel) {
  const auto of = [this](const char* name, const char* key, const char* inputs) {
    return store(name, {record(key, "annealing", 2.0)}, 1.0, {}, {}, inputs);
  };
  const auto merge = [&](Store a, Store b) {
    std::vector<Store> stores;
    stores.push_back(std::move(a));
    stores.push_back(std::move(b));
    return collect(stores, kinds()).problems.at(0).fingerprint;
  };
  EXPECT_EQ(merge(of("a", "k1", "12ab"), of("b", "k2", "12ab")), "12ab");
  EXPECT_EQ(merge(of("c", "k1", ""), of("d", "k2", "12ab")), "12ab");  // an older build didn't say
  EXPECT_THROW((void)merge(of("e", "k1", "12ab"), of("f", "k2", "34cd")), InputError);
}

TEST_F(Collect, TellsOfEachOptimizerHowItWasSetAndEveryTrial) {
  TrialRecord first = record("a0", "annealing", 2.0), second = record("a1", "annealing", 3.0);
  second.repeat = 1;
  first.options.set("steps", 10);
  second.options.set("steps", 10);
  second.end = End::failed;
  second.reason = "<broke>";
  first.health.drift = 1e-9;
  second.health.drift = 1e-7;
  first.conditions = Conditions{"build", "a processor", 2, 4, false, false};
  const std::vector<Store> stores = [&] {
    std::vector<Store> made;
    made.push_back(store("a", {second, first}));
    return made;
  }();
  ReportData data = collect(stores, kinds());
  ASSERT_EQ(data.problems[0].optimizers.size(), 1u);
  OptimizerDetail& detail = data.problems[0].optimizers[0];
  ASSERT_EQ(detail.repeats.size(), 2u);
  EXPECT_EQ(detail.repeats[1].repeat, 1);
  EXPECT_EQ(detail.repeats[1].reason, "<broke>");
  EXPECT_FALSE(detail.repeats[0].curve.empty());
  EXPECT_EQ(detail.health.drift, 1e-7);  // the worst
  EXPECT_EQ(detail.conditions, (std::vector<std::string>{"a processor; 2 jobs at once on 4 cores"}));
  ASSERT_EQ(detail.options.size(), 1u);
  EXPECT_FALSE(detail.knows_request);  // this manifest is an older build's
  EXPECT_FALSE(detail.options[0].differs());

  const std::string page = optimizers_html(data);
  EXPECT_NE(page.find("&lt;broke&gt;"), std::string::npos);
  EXPECT_EQ(page.find("asked for"), std::string::npos);
  EXPECT_NE(page.find("<desc"), std::string::npos);
}

TEST(OptimizerDetail, SaysWhatRanOtherwiseThanAsked) {
  TrialRecord trial;
  trial.use = "nobody-knows";
  trial.options.set("steps", 10);
  trial.options.set("scale", 0.5);
  trial.options.set("seed", 1);
  TrialRecord other = trial;
  other.options.set("seed", 2);
  Value asked;
  asked.set("steps", 20);
  asked.set("scale", 0.5);
  const std::vector<const TrialRecord*> trials = {&trial, &other};
  const OptimizerDetail detail = detail_of("mine", &asked, trials, kinds());
  ASSERT_EQ(detail.options.size(), 3u);
  EXPECT_TRUE(detail.options[0].differs());
  EXPECT_FALSE(detail.options[1].differs());
  EXPECT_FALSE(detail.options[2].differs());  // nobody asked for it
  EXPECT_TRUE(detail.options[2].varies);
  ReportData data;
  data.problems.emplace_back();
  data.problems[0].optimizers = {detail};
  const std::string page = optimizers_html(data);
  EXPECT_NE(
      page.find("<tr class=\"differs\"><th scope=\"row\"><code>steps</code></th><td>20</td><td>10 <strong>(not as "
                "asked for)</strong></td>"),
      std::string::npos);
  EXPECT_NE(page.find("ran with other options than asked for</summary>"), std::string::npos);
}

// A budget of its own, or a size: what follows from the problem has a row for each.
TEST(OptimizerDetail, OptionsThatDifferBetweenProblemsHaveARowForEach) {
  TrialRecord trial;
  trial.use = "nobody-knows";
  trial.options.set("steps", 10);
  trial.options.set("scale", 0.5);
  TrialRecord larger = trial;
  larger.options.set("steps", 70);
  larger.options.set("only", 1);
  ReportData data;
  for (const TrialRecord* one : {&trial, &larger, &trial}) {
    const std::vector<const TrialRecord*> trials = {one};
    ProblemReport& problem = data.problems.emplace_back();
    problem.table.reference.label = "p" + std::to_string(data.problems.size());
    problem.optimizers = {detail_of("mine", nullptr, trials, kinds())};
  }
  const std::string page = optimizers_html(data);
  for (const char* row : {"<code>steps</code> on p1, p3</th><td>10</td>", "<code>steps</code> on p2</th><td>70</td>",
                          "<code>scale</code></th><td>0.5</td>", "<code>only</code> on p2</th><td>1</td>"})
    EXPECT_NE(page.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace nodal::report
