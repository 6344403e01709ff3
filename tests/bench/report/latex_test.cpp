// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <report/report.h>

#include <algorithm>
#include <sstream>

#include "made_store.h"

namespace nodal::report {
namespace {

ReportData data_of(const std::string& label) {
  MadeStore made;
  for (int r = 0; r < 8; ++r) {
    made.add("plate", label, r, {{5, 1.0}}, 4.0 + r);
    made.add("plate", "b", r, {{50, 1.5 + 0.1 * r}}, 4.0 + r);
  }
  std::vector<Store> stores;
  stores.push_back(made.write());
  return collect(stores, Registry());
}

// What stands between "begin" and "end" of every environment closes in order, every row has as many cells as the
// columns say, and braces match.
void expect_well_formed(const std::string& text) {
  std::vector<std::string> open;
  int braces = 0;
  std::size_t cells = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%")) continue;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (i == 0 || line[i - 1] != '\\') braces += (line[i] == '{') - (line[i] == '}');
    EXPECT_EQ(braces, 0) << line;
    if (line.starts_with("\\begin{")) open.push_back(line.substr(7, line.find('}') - 7));
    if (line.starts_with("\\begin{tabular}{")) {
      const std::string columns = line.substr(16);
      cells = columns.find("p{") == 0 ? 5u : columns.size() - 1;
    }
    if (line.starts_with("\\end{")) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(line, "\\end{" + open.back() + "}");
      open.pop_back();
    }
    if (!line.ends_with("\\\\")) continue;
    std::size_t separators = 0;
    for (std::size_t i = 0; i < line.size(); ++i) separators += line[i] == '&' && (i == 0 || line[i - 1] != '\\');
    EXPECT_EQ(separators + 1, cells) << line;
  }
  EXPECT_TRUE(open.empty());
}

TEST(Latex, HasTheAnswerAndATableForEachProblem) {
  const std::string text = latex_tables(data_of("a"));
  expect_well_formed(text);
  for (const char* part : {"\\label{tab:answer}", "\\label{tab:problem-1}", "\\toprule", "\\midrule", "\\bottomrule",
                           // Eight of eight, by Wilson 8/(8 + 1.96²) or more; half a millisecond each.
                           "a & 1.000 [1.000, 1.000] & 8 & 8 of 8 [0.68, 1.00] & 500 µs & 5 \\\\",
                           "b & 1.850 [1.675, 2.025] & 8 & 0 of 8 [0.00, 0.32] & never & never \\\\"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Latex, EscapesWhatItWouldObey) {
  EXPECT_EQ(escape_latex("a_b & 50 % of $x^2 #1 {~} \\input < >"),
            "a\\_b \\& 50 \\% of \\$x\\textasciicircum{}2 \\#1 \\{\\textasciitilde{}\\} \\textbackslash{}input "
            "\\textless{} \\textgreater{}");
  EXPECT_EQ(escape_latex("1 − 2 ≤ 3×"), "1 $-$ 2 $\\leq$ 3$\\times$");
  EXPECT_EQ(escape_latex("\x1B[31m"), "\\textbackslash{}u001b[31m");
  const std::string text = latex_tables(data_of("50%_of & \\input{/etc/passwd}"));
  expect_well_formed(text);
  EXPECT_EQ(text.find("\\input"), std::string::npos);
}

TEST(Latex, OfNothingThereAreNoTables) {
  const std::string text = latex_tables(ReportData{});
  EXPECT_TRUE(text.starts_with("% Made by"));
  EXPECT_EQ(text.find("tabular"), std::string::npos);
}

}  // namespace
}  // namespace nodal::report
