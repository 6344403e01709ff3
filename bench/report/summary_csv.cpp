// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "csv_cells.h"
#include "report.h"

namespace nodal::report {

namespace {

using csv::Cells;
using csv::exact;

Cells header() {
  Cells names = {"problem",
                 "optimizer",
                 "use",
                 "baseline",
                 "gap",
                 "refused",
                 "trials",
                 "runs",
                 "reached",
                 "success_rate",
                 "success_rate_lower",
                 "success_rate_upper"};
  for (const Axis axis : kAxes)
    for (const char* figure : {"expected", "expected_lower", "expected_upper", "median", "multiple"})
      names.push_back(std::string(to_string(axis)) + "_" + figure);
  return names;
}

const TargetFigures* target_of(const ConvergenceFigures* figures, double gap) {
  if (!figures) return nullptr;
  const auto found = std::ranges::find(figures->targets, gap, &TargetFigures::gap);
  return found == figures->targets.end() ? nullptr : &*found;
}

Cells cells_of(const ProblemTable& table, const OptimizerRow& row, const TargetRow& target,
               const ConvergenceFigures* figures) {
  const TargetFigures* more = target_of(figures, target.gap);
  const bool refused = figures && !more;
  Cells cells = {csv::quoted(table.reference.label),
                 csv::quoted(row.label),
                 csv::quoted(row.use),
                 csv::flag(row.baseline),
                 exact(target.gap),
                 csv::flag(refused),
                 std::to_string(row.trials)};
  if (refused) {
    cells.resize(header().size());
    return cells;
  }
  cells.push_back(std::to_string(target.runs));
  cells.push_back(std::to_string(target.reached));
  cells.push_back(exact(target.success_rate));
  const bool success = more && more->success;
  cells.push_back(success ? exact(more->success->lower) : "");
  cells.push_back(success ? exact(more->success->upper) : "");
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    cells.push_back(more ? exact(more->expected[a]) : "");
    const statistics::Interval interval =
        more ? more->interval[a].value_or(statistics::Interval{}) : statistics::Interval{};
    cells.push_back(exact(interval.lower));
    cells.push_back(exact(interval.upper));
    cells.push_back(exact(target.median[a]));
    cells.push_back(exact(target.multiple[a]));
  }
  return cells;
}

}  // namespace

std::string summary_csv(const ReportData& data) {
  std::string text = csv::line(header());
  for (const ProblemReport& problem : data.problems)
    for (const OptimizerRow& row : problem.table.rows) {
      const ConvergenceFigures* figures = data.figures_of(problem.table.reference.label, row.label);
      for (const TargetRow& target : row.targets) text += csv::line(cells_of(problem.table, row, target, figures));
    }
  return text;
}

}  // namespace nodal::report
