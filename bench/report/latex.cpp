// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/number_text.h>
#include <nodal/shown.h>

#include "page_parts.h"
#include "report.h"
#include "table.h"
#include "table_notes.h"

namespace nodal::report {

namespace {

using Cells = std::vector<std::string>;

std::string row(const Cells& cells) { return fmt::format("{} \\\\\n", fmt::join(cells, " & ")); }

// booktabs' rules; every cell is escaped already.
std::string table(const std::string& caption, const std::string& label, const std::string& columns, const Cells& head,
                  const std::vector<Cells>& rows) {
  std::string text = "\\begin{table}\n\\centering\n\\caption{" + caption + "}\n\\label{tab:" + label + "}\n";
  text += "\\begin{tabular}{" + columns + "}\n\\toprule\n" + row(head) + "\\midrule\n";
  for (const Cells& cells : rows) text += row(cells);
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

Cells escaped(Cells cells) {
  for (std::string& cell : cells) cell = escape_latex(cell);
  return cells;
}

std::string answer_table(const ReportData& data) {
  if (data.answer.empty()) return {};
  std::vector<Cells> rows;
  for (const AnswerRow& r : answer_rows(data.answer.verdicts, data.answer.scope, common_quality_name(data)))
    rows.push_back(escaped({r.limits, r.take, r.value, r.ties, r.next}));
  std::string caption = "Which optimizer to take with which budget.";
  for (const std::string& line : scope_lines(data.answer)) caption += " " + line;
  return table(escape_latex(caption), "answer",
               "p{0.14\\linewidth}p{0.16\\linewidth}p{0.2\\linewidth}p{0.2\\linewidth}p{0.2\\linewidth}",
               {"With", "take", "because", "ties", "next"}, rows);
}

// The default gap, or the smallest that is a target where that isn't one.
std::optional<double> told_gap(const ProblemConvergence& problem) {
  if (kDefaultGap >= problem.least_gap) return kDefaultGap;
  const auto least = std::ranges::find_if(kTargetGaps.rbegin(), kTargetGaps.rend(),
                                          [&](double gap) { return gap >= problem.least_gap; });
  return least == kTargetGaps.rend() ? std::nullopt : std::optional(*least);
}

std::string quartiles_text(const std::optional<Quartiles>& q) {
  return q ? fmt::format("{} [{}, {}]", figure_text(q->median, kDigits), figure_text(q->lower, kDigits),
                         figure_text(q->upper, kDigits))
           : "–";
}

std::string problem_table(const ProblemReport& problem, const ProblemConvergence& found, std::size_t index) {
  const std::optional<double> gap = told_gap(found);
  Cells head = {"Optimizer", escape_latex(problem.raced_name()) + " [quartiles]", "Trials"};
  if (gap)
    for (const char* title : {"Reached", "Expected time", "Expected evaluations"}) head.emplace_back(title);
  std::vector<Cells> rows;
  for (const OptimizerRow& optimizer : problem.table.rows) {
    Cells cells = {optimizer.label + (optimizer.baseline ? " (baseline)" : ""), quartiles_text(optimizer.quality),
                   std::to_string(optimizer.trials)};
    const auto figures = std::ranges::find(found.optimizers, optimizer.label, &ConvergenceFigures::optimizer);
    if (gap && figures != found.optimizers.end()) {
      const TargetFigures& target = *std::ranges::find(figures->targets, *gap, &TargetFigures::gap);
      cells.push_back(success_text(target));
      for (const Axis axis : {Axis::seconds, Axis::evaluations}) cells.push_back(expected_text(target, axis));
    }
    cells.resize(head.size());
    rows.push_back(escaped(std::move(cells)));
  }
  std::string caption = problem.table.reference.label + ": " + describe_reference(problem) + ".";
  if (gap)
    caption += fmt::format(
        " Reached, and the expected time and evaluations until then, are of gap {}, with 95 % "
        "intervals (Wilson's; bootstrap).",
        gap_text(*gap));
  if (const std::string note = refused_text(found); !note.empty()) caption += " " + note;
  return table(escape_latex(caption), fmt::format("problem-{}", index + 1), gap ? "lrrrrr" : "lrr", head, rows);
}

}  // namespace

std::string escape_latex(const std::string& text) {
  std::string safe;
  for (const char c : printable(text)) {
    switch (c) {
      case '\\':
        safe += "\\textbackslash{}";
        break;
      case '~':
        safe += "\\textasciitilde{}";
        break;
      case '^':
        safe += "\\textasciicircum{}";
        break;
      case '<':
        safe += "\\textless{}";
        break;
      case '>':
        safe += "\\textgreater{}";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        safe += '\\';
        [[fallthrough]];
      default:
        safe += c;
    }
  }
  // What fonts of T1 lack.
  for (const auto& [sign, command] : {std::pair("−", "$-$"), {"≤", "$\\leq$"}, {"≥", "$\\geq$"}, {"×", "$\\times$"}})
    for (std::size_t at = safe.find(sign); at != std::string::npos; at = safe.find(sign, at + 1))
      safe.replace(at, std::string_view(sign).size(), command);
  return safe;
}

std::string latex_tables(const ReportData& data) {
  std::string text =
      "% Made by nodal report --latex. Needs \\usepackage{booktabs}, \\usepackage[T1]{fontenc}, UTF-8.\n";
  text += answer_table(data);
  for (std::size_t i = 0; i < data.convergence.size(); ++i)
    text += problem_table(data.problems[i], data.convergence[i], i);
  return text;
}

}  // namespace nodal::report
