// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a page as large as real ones for the browser: many optimizers, two problems, one of them with plates.
#include <cmath>
#include <cstdio>
#include <fstream>

#include <nodal/components.h>
#include <nodal/elastic/stiffness.h>
#include <report/html.h>
#include <report/plates.h>
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
}

// A problem without relative error, whose work is its evaluations, with a label that tries to break out.
ProblemReport make_analytic() {
  ProblemReport problem = fixture::make_problem();
  problem.kind = "rosenbrock";
  problem.table.reference = {"rosenbrock </script><script>fail(\"&\")</script>", 0.0, "", false};
  problem.error_per_quality.reset();
  problem.table.start_relative_error.reset();
  for (OptimizerRow& row : problem.table.rows) row.relative_error.reset();
  for (OptimizerCurves& curves : problem.curves) curves.by_axis[2] = curves.by_axis[1];
  return problem;
}

std::vector<Plate> make_plates_of_the_paper() {
  Registry registry;
  register_components(registry);
  const ProblemDescription* kind = registry.find_problem("elastic");
  const Options options = resolve_options(kind->options, Value(), "problem");
  InputFiles files;
  const auto made = kind->make(options, {files, {}});
  const auto problem = std::dynamic_pointer_cast<const elastic::ElasticProblem>(made);
  // Stiffnesses of a square lattice, from soft to stiff: close to what the optimizers find.
  std::vector<double> x = elastic::lattice_stiffness(problem->net(), problem->scene().material);
  for (double& k : x) k = std::log(k);
  ProblemReport report = fixture::make_problem();
  report.best = {"ceres-levenberg-marquardt", 0, 0.7376, x};
  return make_plates(*problem, report);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: sample_report FILE\n", stderr);
    return 2;
  }
  ReportData data = fixture::make_data();
  add_optimizers(data.problems[0], 15);
  data.problems[0].details = fixture::make_details(50);
  data.problems.push_back(make_analytic());
  data.pictures["plate"] = plates_html(make_plates_of_the_paper());
  data.warnings = {"'results' holds results of another build (revision 0123abc; this is 4567def): times don't compare"};
  std::ofstream(argv[1]) << report_html(data);
  return 0;
}
