// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the tables of Figure 12 in docs/reproduction.md: medians over sets of points.
#include <fmt/format.h>

#include "figure12.h"

namespace {

using namespace nodal;
using namespace nodal::paper;

void print_row(const char* name, const std::vector<double>& values) {
  fmt::print("| {} |", name);
  for (const double value : values) fmt::print(" {:.3g} ({:.2f}) |", value, value / values.front());
  fmt::print("\n");
}

// Over the iterations, from one rule of the start.
struct Rows {
  std::vector<double> start, annealed, fitted;
};

Rows rows_from(const char* initial) {
  Rows rows;
  for (const int iterations : iteration_counts()) {
    const std::vector<TrialRecord> annealing = fits(iterations, Fit::annealing, {.initial = initial});
    rows.start.push_back(median_start_error(annealing));
    rows.annealed.push_back(median_best_error(annealing));
    rows.fitted.push_back(median_best_error(fits(iterations, Fit::levenberg_marquardt, {.initial = initial})));
  }
  return rows;
}

void print_iterations() {
  fmt::print("Relative error, median of {} sets of points; in brackets over that without iterations\n\n| iterations |",
             kSeeds);
  for (const int iterations : iteration_counts()) fmt::print(" {} |", iterations);
  fmt::print("\n|---|---|---|---|---|---|\n");
  for (const char* initial : {"\"area\"", "\"paper\"", "{ rule = \"paper\", scale = \"best\" }"}) {
    const Rows rows = rows_from(initial);
    fmt::print("| initial = {} | | | | | |\n", initial);
    print_row("start", rows.start);
    print_row("annealing, 100 temperatures", rows.annealed);
    print_row("Levenberg-Marquardt", rows.fitted);
  }
}

void print_topologies() {
  fmt::print("\nLevenberg-Marquardt after 50 iterations\n\n| topology | ν = 0.3 | ν = 1/3 |\n|---|---|---|\n");
  for (const char* topology : {"delaunay", "delaunay-flip"})
    fmt::print("| `{}` | {:.3g} | {:.3g} |\n", topology,
               median_best_error(fits(50, Fit::levenberg_marquardt, {.topology = topology})),
               median_best_error(fits(50, Fit::levenberg_marquardt, {.topology = topology, .poisson = kOneThird})));
}

}  // namespace

int main() {
  print_iterations();
  print_topologies();
  return 0;
}
