// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/profiles.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

#include <report/convergence_charts.h>
#include <report/page_parts.h>
#include <report/race_chart.h>
#include <report/report.h>

#include "fixture.h"
#include "made_store.h"

namespace nodal::report {
namespace {

constexpr std::size_t kEvaluations = 1;

// One problem whose only targets are 0.1, 0.01, …, with expected evaluations by hand; empty is never.
ProblemConvergence problem_of(const std::vector<std::vector<std::optional<double>>>& expected) {
  ProblemConvergence problem;
  problem.problem = "p";
  for (std::size_t g = expected.front().size(); g < kTargetGaps.size(); ++g) problem.refused.push_back(kTargetGaps[g]);
  const char name[] = {'a', 0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ConvergenceFigures& figures = problem.optimizers.emplace_back();
    figures.optimizer = std::string(1, static_cast<char>(name[0] + i));
    for (std::size_t g = 0; g < expected[i].size(); ++g) {
      TargetFigures& target = figures.targets.emplace_back();
      target.gap = kTargetGaps[g];
      target.expected[kEvaluations] = expected[i][g];
      figures.lengths[kEvaluations].push_back({expected[i][g], 100.0});
    }
  }
  return problem;
}

TEST(Profiles, CountProblemsAndTargets) {
  // a is best at the first, within twice at the second; b the other way round, and never at the third.
  const std::vector<ProblemConvergence> problems = {problem_of({{10.0, 40.0, 70.0}, {30.0, 20.0, {}}})};
  const std::vector<Profiles> all = make_profiles(problems, kAxes);
  ASSERT_EQ(all.size(), 1u);  // no seconds, no work
  const Profiles& profiles = all[0];
  EXPECT_EQ(profiles.axis, Axis::evaluations);
  EXPECT_EQ(profiles.cases, 3u);
  EXPECT_EQ(profiles.factors[0], 1.0);
  EXPECT_EQ(profiles.factors[2], 2.0);
  EXPECT_DOUBLE_EQ(profiles.performance[0][0], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(profiles.performance[1][0], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(profiles.performance[0][2], 1.0);
  EXPECT_DOUBLE_EQ(profiles.performance[1].back(), 2.0 / 3.0);
  EXPECT_EQ(profiles.costs, (std::vector<double>{10, 20, 50, 100}));
  EXPECT_EQ(profiles.data[0], (std::vector<double>{1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 1.0}));
  EXPECT_TRUE(profiles.warning.empty());
  ASSERT_EQ(profiles.reached[1].size(), 2u);
  EXPECT_DOUBLE_EQ(profiles.reached[1].back().share, 2.0 / 3.0);
  // As they are drawn: b costs 20 and 30, which is 1 and 3 times the least.
  const std::vector<statistics::Step>&data = profiles.data_steps[1], &factors = profiles.performance_steps[1];
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0].at, 20.0);
  EXPECT_EQ(data[1].at, 30.0);
  ASSERT_EQ(factors.size(), 2u);
  EXPECT_EQ(factors[0].at, 1.0);
  EXPECT_EQ(factors[1].at, 3.0);
  EXPECT_DOUBLE_EQ(factors[1].share, 2.0 / 3.0);
}

// With all three a is within 1.5 of the best twice, b once; without c, whose times are tiny on one, it is the other
// way.
TEST(Profiles, WarnWhereAThirdDecides) {
  const std::vector<ProblemConvergence> problems = {
      problem_of({{10.0, 90.0, 90.0}, {30.0, 20.0, 20.0}, {10.0, 1.0, 1.0}})};
  const std::string warning = make_profiles(problems, kAxes)[0].warning;
  EXPECT_TRUE(warning.starts_with("Within a factor of 1 a stands above b here, but below it where c is left out"))
      << warning;
}

// 1,000 run lengths of 1, 2, 3, …: 20 of them within 20.
TEST(Profiles, RunLengthsAreToldOfAllSteps) {
  std::vector<ProblemConvergence> problems = {problem_of({{20.0}})};
  std::vector<statistics::RunLength>& lengths = problems[0].optimizers[0].lengths[kEvaluations];
  lengths.clear();
  for (int i = 1; i <= 1000; ++i) lengths.push_back({static_cast<double>(i), 1000.0});
  const Profiles profiles = make_profiles(problems, kAxes).at(0);
  EXPECT_EQ(profiles.reached.at(0).size(), 1000u);
  EXPECT_EQ(profiles.costs, (std::vector<double>{10, 20}));
  const std::string page = profiles_html(profiles, {});
  const std::size_t table = page.find("The run lengths as a table");
  ASSERT_NE(table, std::string::npos);
  EXPECT_NE(page.find("<td>0.01</td><td>0.02</td>", table), std::string::npos) << page.substr(table);
}

TEST(Profiles, OfNothingThereAreNone) {
  EXPECT_TRUE(make_profiles({}, kAxes).empty());
  const std::vector<ProblemConvergence> never = {problem_of({{{}, {}}})};
  EXPECT_TRUE(make_profiles(never, kAxes).empty());
}

TEST(Profiles, StandOnThePageAsChartsAndTables) {
  MadeStore made;
  for (const char* problem : {"p", "q"})
    for (int r = 0; r < 3; ++r) {
      made.add(problem, "a", r, {{5, 1.0}}).work.factorizations = 50;
      made.add(problem, "b", r, {{50, 1.0}}).work.factorizations = 50;
    }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const std::string page = report_html(data);
  for (const char* part :
       {"<h2>Budgets and targets in figures</h2>",
        "<figcaption>Data profile: share of 16 targets of all problems, by their expected time",
        "<figcaption>Performance profile: share of 16 targets of all problems within a factor of the least "
        "evaluations",
        "<figcaption>Run lengths: share of trials × targets reached, by evaluations", "The run lengths as a table",
        "<figcaption>p: relative error attained, against time", "id=\"run-lengths-evaluations-title\"",
        "Area over the convergence curve", "Expected time to a gap", "Wilson&#39;s 95 % interval", "<td>500 µs</td>",
        "<td>1 of 1 [0.21, 1.00]</td>", "id=\"run-lengths-factorizations-title\"",
        "<figcaption>q: relative error attained, against factorizations", "Expected factorizations to a gap"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("flops"), std::string::npos);  // nobody counts any
}

// Costs of nothing stand nowhere beside others.
TEST(Profiles, AreByFactorizationsWhereAllProblemsHaveThem) {
  MadeStore made;
  for (const char* problem : {"p", "q"})
    for (int r = 0; r < 3; ++r) made.add(problem, "a", r, {{5, 1.0}});
  for (TrialRecord& record : made.records())
    if (record.problem == "p") record.work.factorizations = 50;
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  std::vector<Axis> axes;
  for (const Profiles& profiles : data.profiles) axes.push_back(profiles.axis);
  EXPECT_EQ(axes, (std::vector{Axis::seconds, Axis::evaluations}));
}

// Of every table, also where a page has several problems and trials ended at minima.
TEST(Profiles, TablesCanBeReadWithoutSeeingThem) {
  MadeStore made;
  for (const char* problem : {"p", "q"})
    for (int r = 0; r < 3; ++r) {
      made.add(problem, "a", r, {{5, 1.0}}, 4.0 + r).audit = AuditRecord{.stationarity = 0.0};
      made.add(problem, "b", r, {{50, 2.0}}, 4.0 + r);
    }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const std::string page = report_html(data);
  EXPECT_NE(page.find("Mean ranks over problems"), std::string::npos);
  EXPECT_NE(page.find("Where trials ended"), std::string::npos);
  const std::string_view box = "<div class=\"scroll\"";
  for (std::size_t at = page.find(box); at != std::string::npos; at = page.find(box, at + 1))
    EXPECT_TRUE(
        std::string_view(page).substr(at + box.size()).starts_with(" tabindex=\"0\" role=\"region\" aria-label=\""))
        << page.substr(at, 200);
  EXPECT_EQ(page.find("<th>"), std::string::npos);
  for (std::size_t at = page.find("<th "); at != std::string::npos; at = page.find("<th ", at + 1))
    EXPECT_NE(page.substr(at, page.find('>', at) - at).find("scope="), std::string::npos) << page.substr(at, 200);
  EXPECT_NE(page.find("the gap drawn is 1 at that of repeat 0"), std::string::npos);
}

// Of three trials one is never below 4: a quarter and half attain 1, three quarters don't.
TEST(Profiles, AttainedIsDrawnBetweenAQuarterAndThreeQuarters) {
  MadeStore made;
  made.add("p", "a", 0, {{5, 4.0}, {10, 1.0}});
  made.add("p", "a", 1, {{5, 4.0}, {20, 1.0}});
  made.add("p", "a", 2, {{5, 4.0}});
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const LineChart chart = attainment_chart(data.problems[0], data.convergence[0], Axis::evaluations);
  ASSERT_EQ(chart.lines.size(), 1u);
  const ChartLine& line = chart.lines[0];
  EXPECT_TRUE(line.steps && line.band);
  const auto at = [&](double evaluations) { return point_at(line, evaluations, chart.x, chart.y).value(); };
  EXPECT_EQ(at(19.0).y, 1.0);  // the relative error is a quarter of these qualities
  EXPECT_EQ(at(20.0).y, 0.25);
  EXPECT_EQ(at(20.0).lower, 0.25);
  EXPECT_EQ(at(20.0).upper, 1.0);
}

// Nothing is known of such a trial but that it was, and of one that was killed how long it ran.
TEST(Profiles, EveryTrialIsListedAlsoThoseThatDied) {
  MadeStore made;
  for (int repeat = 0; repeat < 2; ++repeat)
    for (const char* name : {"fragile", "broken"}) made.add("p", name, repeat, {{5, 1.0}});
  for (TrialRecord& record : made.records()) {
    if (record.optimizer == "fragile" && record.repeat == 1) continue;
    TrialRecord dead;
    dead.key = record.key;
    dead.problem = record.problem;
    dead.optimizer = dead.use = record.optimizer;
    dead.repeat = record.repeat;
    dead.end = record.repeat == 0 ? End::crashed : End::timeout;
    dead.reason = "signal 11";
    dead.seconds.total = record.repeat == 0 ? 0.0 : 3.0;
    record = dead;
  }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const std::string page = report_html(collect(stores, Registry()));
  for (const char* part : {"<caption>Trials of fragile on p</caption>", "<caption>Trials of broken on p</caption>",
                           "<tr><th scope=\"row\">0</th><td>–</td><td>–</td><td>–</td><td>–</td><td "
                           "class=\"words\">crashed: signal 11</td>",
                           "<tr><th scope=\"row\">1</th><td>–</td><td>–</td><td>–</td><td>3.00 s</td><td "
                           "class=\"words\">timeout: signal 11</td>"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

// Of six trials half have died: three quarters attain nothing, half the worst of the others.
TEST(Profiles, AttainedKeepsALineWhereTrialsDied) {
  MadeStore made;
  for (int repeat = 0; repeat < 6; ++repeat) {
    made.add("p", "fragile", repeat, {{5, 1.0 + repeat}});
    made.add("p", "broken", repeat, {{5, 1.0}});
    made.add("p", "sound", repeat, {{5, 2.0}});
  }
  for (TrialRecord& record : made.records()) {
    if (record.optimizer == "sound" || record.repeat < (record.optimizer == "broken" ? 1 : 3)) continue;
    record.end = End::crashed;
    record.start = {};
    record.best = {};
    record.trace.clear();
  }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const LineChart chart = attainment_chart(data.problems[0], data.convergence[0], Axis::evaluations);
  const auto fragile = std::ranges::find(chart.lines, "fragile", &ChartLine::label);
  const ChartPoint end = point_at(*fragile, 100.0, chart.x, chart.y).value();
  EXPECT_EQ(end.y, 0.75);
  EXPECT_EQ(end.lower, 0.5);
  EXPECT_EQ(end.upper, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::ranges::find(chart.lines, "broken", &ChartLine::label)->points.empty());
  EXPECT_TRUE(
      chart.description.ends_with(" Without a line, because more than half of the trials have no result: broken."))
      << chart.description;
}

// Many steps in one place, and three surfaces that step where the others don't.
TEST(Profiles, AttainedIsWhatTrialsHaveAtEveryCost) {
  MadeStore made;
  for (int repeat = 0; repeat < 8; ++repeat) {
    std::vector<std::pair<std::int64_t, double>> way;
    for (int i = 1; i <= 300; ++i) way.emplace_back(i * (repeat + 1) + i * i / 97, 4.0 * std::pow(0.985, i));
    made.add("p", "a", repeat, way);
  }
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const LineChart chart = drawable(attainment_chart(data.problems[0], data.convergence[0], Axis::evaluations));
  for (const double cost : {2.0, 5.0, 10.0, 50.0, 100.0, 333.0, 1000.0, 2000.0}) {
    std::vector<double> all;
    for (const TrialRecord& record : made.records())
      all.push_back(statistics::quality_at(quality_history(record, Axis::evaluations), cost) / 4.0);
    std::ranges::sort(all);
    const ChartPoint found = point_at(chart.lines.at(0), cost, chart.x, chart.y).value();
    EXPECT_DOUBLE_EQ(found.lower, all[1]) << cost;
    EXPECT_DOUBLE_EQ(found.y, all[3]) << cost;
    EXPECT_DOUBLE_EQ(found.upper, all[5]) << cost;
  }
}

// b has no trial on the first problem, c none on the second.
TEST(Profiles, AnOptimizerLooksTheSameInEveryChart) {
  MadeStore made;
  for (const char* name : {"a", "c"}) made.add("p", name, 0, {{5, 1.0}});
  for (const char* name : {"b", "a"}) made.add("q", name, 0, {{5, 1.0}});
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  std::map<std::string, std::set<std::size_t>> styles;
  const auto look = [&styles](const LineChart& chart) {
    for (const ChartLine& line : chart.lines) styles[line.label].insert(line.style);
  };
  look(profile_charts(data.profiles.at(0), data.problems).data);
  for (std::size_t i = 0; i < 2; ++i) {
    look(race_chart(data.problems[i], Raced::quality, Axis::seconds));
    look(attainment_chart(data.problems[i], data.convergence[i], Axis::seconds));
  }
  EXPECT_EQ(styles, (std::map<std::string, std::set<std::size_t>>{{"a", {0}}, {"c", {1}}, {"b", {2}}}));
  std::map<std::string, std::set<std::string>> colours;
  for (const ProblemReport& problem : data.problems) {
    const Value race = race_data(problem, Raced::quality);
    for (const Value& series : race.at("series").list())
      colours[series.at("label").text()].insert(series.at("colour").text());
  }
  ASSERT_EQ(colours.size(), 3u);
  for (const auto& [label, each] : colours) EXPECT_EQ(each.size(), 1u) << label;
}

// The baseline has a look of its own, everybody else a colour.
TEST(Profiles, LinesOfARaceAreToldApart) {
  const LineChart chart = race_chart(fixture::make_problem(), Raced::quality, Axis::seconds);
  ASSERT_EQ(chart.lines.size(), 3u);
  EXPECT_TRUE(chart.lines[0].baseline);
  EXPECT_FALSE(chart.lines[1].baseline || chart.lines[2].baseline);
  EXPECT_NE(chart.lines[1].style, chart.lines[2].style);
}

// From the race's left end, where evaluation 0 stands, to its right one; also where nothing is ever improved.
TEST(Profiles, AttainedIsDrawnFromTheStartToTheEnd) {
  MadeStore made;
  made.add("p", "a", 0, {{5, 1.0}});
  made.add("p", "still", 0, {});
  std::vector<Store> stores;
  stores.push_back(made.write());
  const ReportData data = collect(stores, Registry());
  const LineChart chart = attainment_chart(data.problems[0], data.convergence[0], Axis::evaluations);
  ASSERT_EQ(chart.lines.size(), 2u);
  for (const ChartLine& line : chart.lines) {
    ASSERT_GE(line.points.size(), 2u) << line.label;
    EXPECT_EQ(line.points.front().x, 1.0) << line.label;
    EXPECT_EQ(line.points.front().y, 1.0) << line.label;
    EXPECT_EQ(line.points.back().x, 5000.0) << line.label;
    EXPECT_EQ(line.points.back().y, line.label == "a" ? 0.25 : 1.0) << line.label;
  }
}

TEST(Convergence, RefusedTargetsAreNamedWithTheReason) {
  ProblemConvergence problem = problem_of({{10.0, 20.0}});
  problem.least_gap = 3e-3;
  EXPECT_EQ(refused_text(problem),
            "No targets: gaps 0.001, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8. The best known quality isn't known well enough: it "
            "may be off by a gap of 0.003.");
  problem.refused.clear();
  EXPECT_EQ(refused_text(problem), "");
}

}  // namespace
}  // namespace nodal::report
