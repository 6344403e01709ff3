// SPDX-License-Identifier: GPL-3.0-or-later
// A race as large as they come: 20 optimizers, 30 repeats, 5 problems, each trial with a long trace.
#include <report/figure_files.h>
#include <report/report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>

#include <nodal/random.h>
#include <nodal/store.h>

#include "../../support/temporary_directory.h"

namespace nodal::report {
namespace {

constexpr int kOptimizers = 20, kRepeats = 30, kProblems = 5, kTracePoints = 300;
constexpr int kHeldOut = 2, kUnseenPoints = 46;  // problems, the first ones; points of a trial
constexpr double kMostSeconds = 12.0;            // of a processor; two or three is what it takes

// Falls from 4 towards a quality of its own in steps that no two trials share.
TrialRecord trial(int problem, int optimizer, int repeat) {
  RandomStream random(static_cast<std::uint64_t>((problem * kOptimizers + optimizer) * kRepeats + repeat));
  TrialRecord r;
  r.key = std::to_string((problem * kOptimizers + optimizer) * kRepeats + repeat);
  r.problem = "problem " + std::to_string(problem);
  r.optimizer = "optimizer with a name " + std::to_string(optimizer);
  r.use = "nlopt-method-" + std::to_string(optimizer);
  r.repeat = repeat;
  r.end = End::budget;
  r.reason = "evaluations spent";
  r.start = {0.5, 4.0, 1.0};
  for (int i = 0; i < 12; ++i) r.options.set("option_" + std::to_string(i), 0.1 * i);
  const double best = 0.7 + 0.1 * optimizer + 0.05 * random.uniform(0.0, 1.0);
  double left = 1.0, seconds = 1e-4;
  std::int64_t evaluation = 0;
  for (int i = 0; i < kTracePoints; ++i) {
    r.trace.push_back({evaluation, seconds, 1 + evaluation / 3, best + (4.0 - best) * left});
    left *= random.uniform(0.9, 1.0);
    evaluation += 1 + static_cast<std::int64_t>(random.index(static_cast<std::size_t>(1 + i)));
    seconds = 1e-4 + 2e-5 * static_cast<double>(evaluation);
  }
  r.best = BestPoint{evaluation, {0.01, r.trace.back().quality, r.trace.back().quality / 4.0}, std::vector(72, 0.1)};
  if (problem < kHeldOut) {
    r.unseen.emplace().names = {"bend-x", "bend-y"};
    for (int i = 0; i < kUnseenPoints; ++i)
      r.unseen->points.push_back({r.trace[static_cast<std::size_t>(i * (kTracePoints - 1) / (kUnseenPoints - 1))],
                                  {random.uniform(0.1, 0.5), random.uniform(0.1, 0.5)}});
  }
  r.counts.evaluations = 2 * evaluation;
  r.work = {evaluation, 3 * evaluation, 0, 1e5 * static_cast<double>(evaluation),
            5e4 * static_cast<double>(evaluation)};
  r.flops_per_value = 2e4;
  r.seconds.total = 2.0 * seconds;
  r.conditions = Conditions{"build", "a processor", 1, 2, false, false};
  return r;
}

Value manifest() {
  Value::List problems, optimizers;
  for (int p = 0; p < kProblems; ++p)
    problems.emplace_back(Value::Table{{"label", trial(p, 0, 0).problem}, {"kind", "unknown"}, {"options", Value()}});
  for (int o = 0; o < kOptimizers; ++o)
    optimizers.emplace_back(Value::Table{
        {"label", trial(0, o, 0).optimizer}, {"use", trial(0, o, 0).use}, {"baseline", o == 0}, {"options", Value()}});
  return Value::Table{{"schema", 1},
                      {"study", Value::Table{{"name", "large"}, {"text", "[study]\n"}}},
                      {"problems", std::move(problems)},
                      {"optimizers", std::move(optimizers)}};
}

const std::filesystem::path& large_store() {
  static const toy::TemporaryDirectory folder;
  static const std::filesystem::path path = [] {
    const std::filesystem::path store = folder.path() / "large";
    std::filesystem::create_directories(store / "trials");
    std::ofstream(store / "manifest.json") << to_json(manifest());
    std::ofstream lines(store / "trials" / "1.jsonl");
    for (int p = 0; p < kProblems; ++p)
      for (int o = 0; o < kOptimizers; ++o)
        for (int r = 0; r < kRepeats; ++r) lines << to_json_line(trial(p, o, r)) << '\n';
    return store;
  }();
  return path;
}

ReportData large_report() {
  const Registry registry;
  std::vector<Store> stores;
  stores.push_back(Store::open_existing(large_store()));
  return collect(stores, registry);
}

TEST(LargeReport, IsSmallerThanFiveMegabytesAndTheSameEachTime) {
  (void)large_store();
  const std::clock_t began = std::clock();
  const ReportData data = large_report();
  const std::string page = report_html(data);
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  RecordProperty("bytes", std::to_string(page.size()));
  std::printf("made in %.2f s of a processor, %.2f MB\n", seconds, 1e-6 * static_cast<double>(page.size()));
#ifdef NDEBUG
  EXPECT_LT(seconds, kMostSeconds);
#endif
  ASSERT_EQ(data.problems[0].optimizers.size(), static_cast<std::size_t>(kOptimizers));
  EXPECT_EQ(data.problems[0].optimizers[0].repeats.size(), static_cast<std::size_t>(kRepeats));
  EXPECT_LT(page.size(), 5'000'000u);
  EXPECT_EQ(report_html(large_report()), page);
}

TEST(LargeReport, HasFiguresOfItsOwnForEveryProblemAndAxis) {
  const std::vector<FigureFile> files = figure_files(large_report());
  std::set<std::string> names;
  for (const FigureFile& file : files) {
    names.insert(file.name);
    EXPECT_LT(file.svg.size(), 100'000u);
  }
  // Errors, gaps, unseen errors, what was attained, and three profiles, over four axes each.
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kProblems * (2 * 4 + 4) + kHeldOut * 4 + 3 * 4));
  EXPECT_TRUE(names.contains("problem-0-error-time.svg"));
  EXPECT_TRUE(names.contains("problem-0-attained-flops.svg"));
  EXPECT_TRUE(names.contains("all-problems-run-lengths-evaluations.svg"));
  EXPECT_TRUE(std::ranges::all_of(files, [](const FigureFile& file) { return is_figure_file(file.svg); }));
}

}  // namespace
}  // namespace nodal::report
