// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a page as large as real ones for the browser: many optimizers, two problems, one of them with plates.
#include <cmath>
#include <cstdio>
#include <fstream>

#include <nodal/components.h>
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/stiffness.h>
#include <report/report.h>

#include "../bench/report/fixture.h"

namespace {

using namespace nodal;
using namespace nodal::report;

// Enough optimizers that every colour is used and dashes begin.
void add_optimizers(ProblemReport& problem, std::size_t total) {
  for (std::size_t i = problem.table.rows.size(); i < total; ++i) {
    const double slower = 1.0 + 0.7 * static_cast<double>(i);
    OptimizerRow row = fixture::make_row("optimizer number " + std::to_string(i),
                                         0.0922 + 0.004 * static_cast<double>(i), 0.01 * slower);
    fixture::set_reached(row, 0, 0.002 * slower, 6.0 / slower);
    OptimizerCurves curves{row.label, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      curves.by_axis[axis] = fixture::make_curve_down(2.304, row.quality->median, axis == 0 ? 1e-4 : 1.0,
                                                      (axis == 0 ? 0.01 : 3000.0) * slower);
    problem.table.rows.push_back(row);
    problem.curves.push_back(curves);
  }
  fixture::name_contestants(problem);
}

// A problem without relative error, whose work is its evaluations, with a label that tries to break out.
ProblemReport make_analytic() {
  ProblemReport problem = fixture::make_problem();
  problem.kind = "rosenbrock";
  problem.quality_name = "quality";
  problem.table.reference = {"rosenbrock </script><script>fail(\"&\")</script>", 0.0, "", false};
  problem.error_per_quality.reset();
  problem.table.start_relative_error.reset();
  for (OptimizerRow& row : problem.table.rows) row.relative_error.reset();
  for (OptimizerCurves& curves : problem.curves) curves.by_axis[2] = curves.by_axis[1];
  return problem;
}

const ProblemDescription& elastic_kind() {
  static Registry registry;
  if (registry.problems().empty()) register_components(registry);
  return *registry.find_problem("elastic");
}

ReportPart pictures_of_the_paper() {
  const Options options = resolve_options(elastic_kind().options, Value(), "problem");
  InputFiles files;
  const auto made = elastic_kind().make(options, {files, {}});
  const auto problem = std::dynamic_pointer_cast<const elastic::ElasticProblem>(made);
  // Stiffnesses of a square lattice, from soft to stiff: close to what the optimizers find.
  std::vector<double> x = elastic::lattice_stiffness(problem->net(), problem->scene().material);
  for (double& k : x) k = std::log(k);
  const std::span<const double> start = problem->space().start();
  const std::vector<LabelledPoint> points = {{"start", {start.begin(), start.end()}},
                                             {"best: ceres-levenberg-marquardt", x}};
  return problem->exhibit()->report("plate", points);
}

// Deviations that halve with every iteration, an energy that comes near that of hexagons, masses of full rank.
ReportPart details_of(int iterations) {
  Value::List steps;
  for (int i = 0; i <= iterations; ++i) {
    const double left = std::pow(0.5, i);
    steps.emplace_back(Value::Table{{"iteration", i},
                                    {"distance_deviation", 0.1 + 0.4 * left},
                                    {"area_deviation", 0.2 + 0.6 * left},
                                    {"energy", 0.0802 * (1.03 + left)},
                                    {"inner_energy", 0.0802 * (1.02 + 0.75 * left)}});
  }
  const Value masses = Value::Table{{"form", "positive"},
                                    {"message", "all moments are the body's"},
                                    {"smallest", 0.125},
                                    {"rank", 6},
                                    {"moment_errors", Value::Table{{"∫1", 0.0}, {"∫x²", 2.5e-15}}}};
  return elastic_kind().show_details(Value::Table{{"voronoi", std::move(steps)}, {"masses", masses}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: sample_report FILE\n", stderr);
    return 2;
  }
  ReportData data = fixture::make_data();
  add_optimizers(data.problems[0], 15);
  data.problems[0].details = details_of(50);
  data.problems.push_back(make_analytic());
  data.pictures["plate"] = pictures_of_the_paper();
  data.warnings = {"'results' holds results of another build (revision 0123abc; this is 4567def): times don't compare"};
  std::ofstream(argv[1]) << report_html(data);
  return 0;
}
