// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <nodal/show/number_text.h>
#include <report/report.h>
#include <report/table.h>

#include <algorithm>
#include <sstream>

#include "fixture.h"

namespace nodal::report {
namespace {

constexpr const char* kLegend =
    "Best first: by error as printed, equal ones by time to gap 0.01. Times and counts are medians over trials.\n"
    "Gap = (G − G*)/(G at the start − G*): 1 at the start, 0 at G*, the best known. \"Time to 0.01\" is the time to "
    "that gap.\n"
    "Never: the median trial doesn't get there. Times faster: the baseline's time to gap 0.01 over this one's.\n"
    "Reached: distinct runs that got to gap 0.01, of all; repeats that did the same until then count once. det.: "
    "deterministic.\n";

TEST(ConsoleTable, SaysWhoGetsHowCloseHowFast) {
  ReportData data = fixture::make_data();
  data.failed.clear();
  data.left_out.clear();
  EXPECT_EQ(
      console_table(data, 160),
      std::string(
          R"(plate: G at the start 2.304 (relative error 0.2880); G* = 0.7376 (multi-start Gauss-Newton, 12 starts agree)

                           relative                           G  evalu-  factori-    total  time to  time to  time to   times   reached    runs  failed
optimizer                     error         [quartiles]  median  ations   zations     time      0.1     0.01    0.001  faster      0.01
ceres-levenberg-marquardt   0.09220  [0.09211, 0.09230]  0.7376  20,736         –  1.72 ms   500 µs   600 µs   700 µs    333×    1 of 1  det. 3       0
annealing (baseline)        0.09380  [0.09371, 0.09389]  0.7504  20,736       152   431 ms  12.3 ms   200 ms    never      1×  14 of 15      15       0
random-search                0.2811    [0.2808, 0.2814]   2.249  20,736       152   500 ms    never    never    never   never   0 of 15      15       2

)") + kLegend);
}

// The smallest numbers there are, rows like any other.
TEST(ConsoleTable, SortsSubnormalQualities) {
  ReportData data = fixture::make_data();
  std::vector<OptimizerRow>& rows = data.problems[0].table.rows;
  for (OptimizerRow& row : rows) row.relative_error.reset();
  rows[0].quality = Quartiles{5e-324, 5e-324, 5e-324};
  rows[1].quality = Quartiles{1.7e-308, 1.7e-308, 1.7e-308};
  rows[2].quality = Quartiles{0.0, 2.2e-309, 3.4e-308};
  const std::string text = console_table(data);
  const std::size_t first = text.find("4.941e-324"), second = text.find("2.200e-309"), third = text.find("1.700e-308");
  EXPECT_LT(first, second) << text;
  EXPECT_LT(second, third);
  EXPECT_NE(third, std::string::npos);
  EXPECT_EQ(rounded(5e-324, 4), 5e-324);
  EXPECT_EQ(rounded(0.0999951, 4), 0.1);
}

TEST(ConsoleTable, LetsNothingThroughThatATerminalWouldObey) {
  ReportData data = fixture::make_data();
  data.problems[0].table.reference.label = data.problems[0].table.rows[1].label = data.failed[0].reason =
      data.left_out[0].reason = "\x1b[2J\r\nfake: 1 2 3";
  const std::string text = console_table(data);
  EXPECT_EQ(text.find_first_of("\x1b\r"), std::string::npos);
  EXPECT_EQ(text.find("\nfake"), std::string::npos);
}

TEST(ConsoleTable, NamesFailuresAndWhatIsLeftOut) {
  const std::string text = console_table(fixture::make_data());
  EXPECT_NE(text.find("Left out: stogo: this build has NLopt without StoGO\n"), std::string::npos);
  EXPECT_NE(text.find("Failed: random-search on plate, repeat 5, timeout: killed after 2 s\n"), std::string::npos);
}

std::size_t widest_row(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  // The heading and the legend wrap by themselves; rows must not.
  for (std::string line; std::getline(lines, line);)
    if (line.find("search") != std::string::npos || line.find("annealing") != std::string::npos)
      widest = std::max(widest, display_width(line));
  return widest;
}

TEST(ConsoleTable, LeavesOutColumnsBeforeItGetsTooWide) {
  ReportData data = fixture::make_data();
  data.failed.clear();
  for (const std::size_t width : {148u, 133u, 123u}) EXPECT_LE(widest_row(console_table(data, width)), width);
  EXPECT_NE(console_table(data, 123).find("(left out to fit 123 columns: quartiles, factorizations)"),
            std::string::npos);
  EXPECT_NE(console_table(data, 40).find("quartiles, factorizations, evaluations)"), std::string::npos);
}

TEST(ConsoleTable, SaysHowManyCoordinatesLieAtABound) {
  ReportData data = fixture::make_data();
  for (OptimizerRow& row : data.problems[0].table.rows) row.at_bounds = Quartiles{0.0, 0.0, 0.0};
  EXPECT_EQ(console_table(data, 200).find("bounds"), std::string::npos);
  data.problems[0].table.rows[1].at_bounds = Quartiles{15.0, 16.0, 17.0};
  const std::string text = console_table(data, 200);
  EXPECT_NE(text.find("  at  "), std::string::npos) << text;
  EXPECT_NE(text.find("  bounds  "), std::string::npos) << text;
  EXPECT_NE(text.find("  16  "), std::string::npos) << text;
  EXPECT_NE(report_html(data).find(">16</td>"), std::string::npos);
}

TEST(ConsoleTable, MarksTrialsThatWereDisturbed) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(console_table(data).find("†"), std::string::npos);
  data.problems[0].table.rows[0].contaminated = 2;
  data.problems[0].table.rows[2].contaminated = 1;
  for (const std::string& text : {console_table(data), report_html(data)}) {
    EXPECT_NE(text.find("annealing (baseline) †"), std::string::npos);
    EXPECT_NE(text.find("random-search †"), std::string::npos);
    EXPECT_NE(text.find("† 3 of 33 trials did not have a processor core to themselves"), std::string::npos) << text;
    EXPECT_NE(text.find("(annealing 2, random-search 1)"), std::string::npos) << text;
  }
}

TEST(ConsoleTable, SaysWhichTrialsTimesComeFrom) {
  ReportData data = fixture::make_data();
  EXPECT_EQ(console_table(data).find("ran alone"), std::string::npos);
  std::vector<OptimizerRow>& rows = data.problems[0].table.rows;
  for (OptimizerRow& row : rows) row.timed = row.trials;
  EXPECT_EQ(console_table(data).find("ran alone"), std::string::npos);
  rows[0].timed = 3;
  rows[2].timed_alone = false;
  for (const std::string& text : {console_table(data, 400), report_html(data)}) {
    EXPECT_NE(
        text.find(fmt::format("Times are of the trials that ran alone and undisturbed, all else is of all: 3 of {} "
                              "({}).",
                              rows[0].trials, rows[0].label)),
        std::string::npos)
        << text;
    EXPECT_NE(text.find(fmt::format("No trial of {} ran alone and undisturbed", rows[2].label)), std::string::npos)
        << text;
  }
}

// G* = G at the start: nobody had to search, and nobody is faster.
TEST(ConsoleTable, SaysThatTheStartIsTheBest) {
  ReportData data = fixture::make_data();
  ProblemTable& table = data.problems[0].table;
  table.start_is_best = true;
  for (OptimizerRow& row : table.rows)
    for (TargetRow& target : row.targets) {
      fixture::set_success(target, 1, 1);
      target.median.fill(0.0);
      target.multiple.fill(std::nullopt);
    }
  const std::string text = console_table(data, 200);
  EXPECT_NE(text.find(", the best there is: every trial has reached each gap at its start; G* = "), std::string::npos)
      << text;
  EXPECT_EQ(text.find(" never"), std::string::npos) << text;
  EXPECT_NE(text.find("  at the start   1 of 1"), std::string::npos) << text;
  // The best of trials that found nothing says nothing, unless it is a perfect fit.
  table.reference.provisional = table.reference.unimproved = true;
  table.start_is_best = false;
  EXPECT_NE(console_table(data, 200).find("which no trial has improved"), std::string::npos);
  EXPECT_EQ(console_table(data, 200).find("the best there is"), std::string::npos);
  table.start_is_best = true;
  EXPECT_NE(console_table(data, 200).find("the best there is"), std::string::npos);
}

TEST(ConsoleTable, SaysWhichOneNeverGetsThere) {
  ReportData data = fixture::make_data();
  std::vector<OptimizerRow>& rows = data.problems[0].table.rows;
  rows[0].targets[1].median.fill(std::nullopt);
  rows[1].targets[1].multiple.fill(std::nullopt);
  const std::string text = console_table(data);
  EXPECT_NE(text.find("baseline never"), std::string::npos);  // where the other does
  EXPECT_NE(text.find("both never"), std::string::npos);
}

TEST(ConsoleTable, CallsAProvisionalOptimumProvisional) {
  ReportData data = fixture::make_data();
  data.problems[0].table.reference = {"plate", 0.75, "the best of these trials", true};
  EXPECT_NE(console_table(data).find("G* = 0.7500, provisional: the best of these trials\n"), std::string::npos);
}

TEST(ConsoleTable, AlignsLabelsThatAreNotAscii) {
  ReportData data = fixture::make_data();
  data.problems[0].table.rows[2].label = "Zufällige Größe µ×–";
  std::istringstream lines(console_table(data, 200));
  std::vector<std::size_t> widths;
  for (std::string line; std::getline(lines, line);)
    if (line.find(" of 1") != std::string::npos) widths.push_back(display_width(line));
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_EQ(std::ranges::count(widths, widths[0]), 3);
}

TEST(ConsoleTable, HasAColumnForAFindingThatIsTabled) {
  ReportData data = fixture::make_data();
  ProblemReport& problem = data.problems[0];
  problem.findings = {{.name = "half_life", .title = "half-life", .unit = "s", .tabled = true},
                      {.name = "sag", .title = "sag"}};
  problem.table.rows[0].findings["half_life"] = {1.5, 2.5, 3.5};
  problem.table.rows[0].findings["sag"] = {7.5, 8.5, 9.5};
  const std::string text = console_table(data, 200);
  EXPECT_NE(text.find("half-life"), std::string::npos) << text;
  EXPECT_NE(text.find("[s]"), std::string::npos) << text;
  EXPECT_NE(text.find("2.500"), std::string::npos) << text;
  EXPECT_EQ(text.find("sag"), std::string::npos) << text;
  // It goes first where a terminal is narrow, and is said.
  EXPECT_NE(console_table(data, 100).find("(left out to fit 100 columns: half-life"), std::string::npos);
}

TEST(ConsoleTable, HasUnseenErrorsBesideTheFittedOnesAndSaysWhoIsWorseThanTheStart) {
  ReportData data = fixture::make_data();
  ProblemReport& problem = data.problems[0];
  EXPECT_EQ(console_table(data, 200).find("unseen"), std::string::npos);
  problem.findings = {unseen_finding()};
  problem.table.rows[0].findings["unseen"] = {0.1, 0.4689, 0.5};
  problem.table.rows[1].findings["unseen"] = {0.01, 0.02, 0.03};
  problem.table.unseen = UnseenSummary{{"pull"}, {}, 0.284};
  std::string text = console_table(data, 200);
  EXPECT_NE(text.find("(relative error 0.2880, unseen 0.2840)"), std::string::npos) << text;
  EXPECT_NE(text.find("0.4689"), std::string::npos) << text;
  EXPECT_EQ(text.find("Worse than"), std::string::npos) << text;
  problem.table.rows[0].unseen = UnseenRow{0.4689, 1.651, 0.07};
  problem.table.rows[1].unseen = UnseenRow{0.05, 0.1, 0.0125};
  problem.table.rows[1].unseen_missing = 1;
  text = console_table(data, 200);
  EXPECT_NE(text.find("Worse than their starts in what is held out: " + problem.table.rows[0].label + " (1.65 times)."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("rose while the fitted one fell: " + problem.table.rows[1].label + " (0.01250)."),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("What is held out can't be evaluated at the best point of 1 trial."), std::string::npos) << text;
  EXPECT_EQ(text.find("stop ="), std::string::npos) << text;
  // Other columns leave before it.
  EXPECT_NE(console_table(data, 100).find("unseen"), std::string::npos);
  problem.table.unseen = UnseenSummary{{"pull"}, {"bend-x", "shear"}, 0.6};
  text = console_table(data, 200);
  EXPECT_NE(text.find("stop = \"unseen\": bend-x, shear chose which point of a trial is reported; unseen errors are "
                      "those of pull."),
            std::string::npos)
      << text;
}

TEST(ConsoleTable, SaysBelowTheTableWhatIsToBeKnownOfAnyResult) {
  ReportData data = fixture::make_data();
  data.problems[0].notes = {"2 displacements can't determine 5\x1b[2J stiffnesses"};
  EXPECT_NE(console_table(data, 200).find("\nAt the start: 2 displacements can't determine 5\\u001b[2J stiffnesses.\n"),
            std::string::npos)
      << console_table(data, 200);
}

TEST(ConsoleTable, NamesWhoClaimsWhatTheMeterDidNotSee) {
  ReportData data = fixture::make_data();
  OptimizerScrutiny liar{"random-search", {}, {}}, loser{"annealing", {}, {}};
  liar.claims = {15, {2, 7, 0.125, 0.5}, {}, 0, {15, 3, 900, 1000}};
  loser.claims = {15, {}, {1, 4, 2.0, 0.75}, 1, {}};
  data.problems[0].scrutiny.optimizers = {liar, loser};
  data.problems[0].scrutiny.aliases = {{"annealing", "my annealing", 3}};
  const std::string text = console_table(data);
  for (const char* note :
       {"random-search claims a cost of 0.125 where a fresh evaluation of its best point says 0.5 (2 of 15 trials; "
        "repeat 7).\n",
        "annealing claims a cost of 2 though it had been at 0.75 (1 of 15 trials; repeat 4).\n",
        "Evaluations that methods claim (and the meter's): random-search 900 (1000).\n",
        "annealing and my annealing are one: they found the same qualities at the same evaluations, in all 3 repeats",
        "The table has what the meter saw"})
    EXPECT_NE(text.find(note), std::string::npos) << note << "\n" << text;
}

TEST(ConsoleTable, CallsTheQualityAsTheKindDoes) {
  ReportData data = fixture::make_data();
  data.problems[0].quality_name = "Q";
  const std::string one = console_table(data);
  EXPECT_NE(one.find("plate: Q at the start 2.304 (relative error 0.2880); Q* = 0.7376"), std::string::npos) << one;
  EXPECT_NE(one.find("Gap = (Q − Q*)/(Q at the start − Q*)"), std::string::npos) << one;
  data.problems.push_back(fixture::make_problem());  // G
  EXPECT_NE(console_table(data).find("Gap = (quality − quality*)/"), std::string::npos);
}

// As in verdicts: its median trial has nothing, however good the others are.
TEST(ConsoleTable, PutsLastWhatMostlyFailed) {
  ReportData data = fixture::make_data();
  std::vector<std::string> before = make_text_table(data.problems[0]).optimizers;
  const auto best = std::ranges::find(data.problems[0].table.rows, before.front(), &OptimizerRow::label);
  best->trials = 3;
  best->failed = 1;
  EXPECT_EQ(make_text_table(data.problems[0]).optimizers, before);
  best->failed = 2;
  std::rotate(before.begin(), before.begin() + 1, before.end());
  EXPECT_EQ(make_text_table(data.problems[0]).optimizers, before);
}

// A best known quality that was given with one digit.
TEST(ConsoleTable, LeavesOutTargetsThatAreRefused) {
  ReportData data = fixture::make_data();
  data.problems[0].least_gap = 0.002;
  const std::string text = console_table(data, 200);
  EXPECT_EQ(text.find(" 0.001"), std::string::npos) << text;
  EXPECT_NE(text.find("Gaps below 0.002 are no targets and not shown: G* isn't known well enough"), std::string::npos);
  EXPECT_NE(text.find("reached"), std::string::npos);
  data.problems[0].least_gap = 0.02;
  EXPECT_EQ(console_table(data, 200).find("reached"), std::string::npos);
}

}  // namespace
}  // namespace nodal::report
