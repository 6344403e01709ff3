// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A race that never ran: data of a report with known figures, for exact comparisons.

#include <cmath>
#include <string>
#include <vector>

#include <report/report_data.h>

namespace nodal::report::fixture {

inline Quartiles around(double median, double share = 0.1) {
  return {median * (1.0 - share), median, median * (1.0 + share)};
}

inline OptimizerRow make_row(const std::string& label, double error, double seconds) {
  OptimizerRow row;
  row.label = row.use = label;
  row.trials = 15;
  row.quality = around(8.0 * error, 0.001);
  row.relative_error = around(error, 0.001);
  row.evaluations = around(20736.0);
  row.factorizations = around(152.0);
  row.seconds = around(seconds);
  row.work = around(1234.5);
  row.starts = 1;
  for (std::size_t i = 0; i < kTargetGaps.size(); ++i) {
    row.targets[i].gap = kTargetGaps[i];
    row.targets[i].runs = row.trials;
  }
  return row;
}

inline void set_success(TargetRow& target, std::size_t reached, std::size_t runs) {
  target.reached = reached;
  target.runs = runs;
  target.success_rate = static_cast<double>(reached) / static_cast<double>(runs);
}

/// Three repeats that did the same.
inline void make_deterministic(OptimizerRow& row) {
  row.deterministic = true;
  row.trials = 3;
  for (TargetRow& target : row.targets) set_success(target, target.reached > 0 ? 1 : 0, 1);
}

/// Reached at `seconds`, by every trial, `multiple` times faster than the baseline.
inline void set_reached(OptimizerRow& row, std::size_t gap, double seconds, std::optional<double> multiple) {
  set_success(row.targets[gap], row.targets[gap].runs, row.targets[gap].runs);
  row.targets[gap].median = {seconds, 1000.0 * seconds, 100.0 * seconds};
  row.targets[gap].multiple = {multiple, multiple, multiple};
}

inline std::vector<CurvePoint> make_curve_down(double from, double to, double begin, double end) {
  std::vector<CurvePoint> curve;
  constexpr int kPoints = 60;
  for (int i = 0; i <= kPoints; ++i) {
    const double t = static_cast<double>(i) / kPoints;
    const double quality = to + (from - to) * std::pow(1.0 - t, 3.0);
    curve.push_back({begin * std::pow(end / begin, t), around(quality, 0.05 * (1.0 - t))});
  }
  return curve;
}

/// After its rows are made.
inline void name_contestants(ProblemReport& problem) {
  problem.contestants.clear();
  for (const OptimizerRow& row : problem.table.rows) problem.contestants.push_back({row.label, row.use, row.baseline});
}

inline ProblemReport make_problem() {
  ProblemReport problem;
  problem.kind = "elastic";
  problem.quality_name = "G";
  problem.quality_help = "the paper's quality measure: smaller is better";
  problem.table.reference = {"plate", 0.7376255865, "multi-start Gauss-Newton, 12 starts agree", false};
  problem.table.start_quality = 2.304;
  problem.table.start_relative_error = 0.288;
  problem.error_per_quality = 0.125;
  problem.table.axes = {Axis::seconds, Axis::evaluations, Axis::work};

  OptimizerRow annealing = make_row("annealing", 0.0938, 0.431);
  annealing.baseline = true;
  set_reached(annealing, 0, 0.0123, 1.0);
  set_reached(annealing, 1, 0.2, 1.0);
  set_success(annealing.targets[1], 14, 15);
  OptimizerRow ceres = make_row("ceres-levenberg-marquardt", 0.0922032, 0.00172);
  for (std::size_t gap = 0; gap < kTargetGaps.size(); ++gap)
    set_reached(ceres, gap, 0.0005 * (1.0 + 0.2 * static_cast<double>(gap)), std::nullopt);
  ceres.targets[0].multiple[0] = 24.6;
  ceres.targets[1].multiple[0] = 333.3;
  ceres.factorizations.reset();
  make_deterministic(ceres);
  OptimizerRow random = make_row("random-search", 0.2811, 0.5);
  random.failed = 2;
  random.reasons = {"the plate broke"};
  problem.table.rows = {annealing, ceres, random};
  name_contestants(problem);

  for (const OptimizerRow& row : problem.table.rows) {
    OptimizerCurves curves{row.label, {}};
    curves.by_axis[0] = make_curve_down(2.304, row.quality->median, 1e-4, row.seconds->median);
    curves.by_axis[1] = make_curve_down(2.304, row.quality->median, 1.0, 20736.0);
    curves.by_axis[2] = make_curve_down(2.304, row.quality->median, 1.0, 1234.5);
    problem.curves.push_back(curves);
  }
  problem.best = {"ceres-levenberg-marquardt", 0, 0.7376, {0.0, 0.0}, std::nullopt};
  return problem;
}

inline ReportData make_data() {
  ReportData data;
  data.study_name = "plate";
  data.study_text = "[study]\nname = \"plate\"\n";
  data.problems = {make_problem()};
  Value build;
  build.set("revision", "0123abc");
  build.set("compiler", "GNU 12.2.0");
  build.set("libraries", Value::Table{{"CHOLMOD", "3.0.14"}, {"NLopt", "2.7.1"}});
  data.builds = {build};
  data.failed = {{"plate", "random-search", 3, End::failed, "the plate broke"},
                 {"plate", "random-search", 5, End::timeout, "killed after 2 s"}};
  data.left_out = {{"stogo", "nlopt-gd-stogo", "this build has NLopt without StoGO"}};
  return data;
}

}  // namespace nodal::report::fixture
