// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the tables of Figure 12, medians over sets of points, into a page: figure12 docs/reproduction.md
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/show/number_text.h>

#include "../../docs/marked_table.h"
#include "figure12.h"

namespace nodal::paper {

namespace {

using Row = std::vector<std::string>;

constexpr int kDigits = 3, kPrintedDigits = 2;

// A value, and what remains of the first.
Row with_shares(const std::string& name, const std::vector<double>& values, int digits) {
  Row row = {name};
  for (const double value : values)
    row.push_back(figure_text(value, digits) +
                  (row.size() == 1 ? "" : fmt::format(" ({:.2f})", value / values.front())));
  return row;
}

Row ratios(const std::string& name, const std::vector<double>& before, const std::vector<double>& after) {
  Row row = {name};
  for (std::size_t i = 0; i < before.size(); ++i) row.push_back(fmt::format("{:.1f}", before[i] / after[i]));
  return row;
}

void add_start(const std::string& name, const char* initial, std::vector<Row>& rows) {
  std::vector<double> start, annealed, fitted;
  for (const int iterations : iteration_counts()) {
    const std::vector<TrialRecord> annealing = fits(iterations, Fit::annealing, {.initial = initial});
    start.push_back(median_start_error(annealing));
    annealed.push_back(median_best_error(annealing));
    fitted.push_back(median_best_error(fits(iterations, Fit::levenberg_marquardt, {.initial = initial})));
  }
  rows.push_back({"**here, relative error, start " + name + "**", "", "", "", "", ""});
  rows.push_back(with_shares("before optimization", start, kDigits));
  rows.push_back(with_shares("annealing, 100 temperatures (baseline)", annealed, kDigits));
  rows.push_back(with_shares("Levenberg-Marquardt", fitted, kDigits));
  rows.push_back(ratios("before over after, annealing", start, annealed));
}

std::string iterations_table() {
  const std::vector<double> before = {8.6, 7.8, 7.6, 6.0, 6.1}, after = {0.45, 0.47, 0.44, 0.42, 0.37};  // the paper's
  std::vector<Row> rows = {{"iterations"}, {"**the paper, G_{1:3:15}**", "", "", "", "", ""}};
  for (const int iterations : iteration_counts()) rows[0].push_back(std::to_string(iterations));
  rows.push_back(with_shares("before optimization", before, kPrintedDigits));
  rows.push_back(with_shares("after 100 temperatures", after, kPrintedDigits));
  rows.push_back(ratios("before over after", before, after));
  add_start("`area`", "\"area\"", rows);
  add_start("`paper`", "\"paper\"", rows);
  add_start("`paper` at its best factor", "{ rule = \"paper\", scale = \"best\" }", rows);
  return docs::markdown_table(rows);
}

std::string topologies_table() {
  std::vector<Row> rows = {{"topology", "ν = 0.3", "ν = 1/3"}};
  for (const char* topology : {"delaunay", "delaunay-flip"}) {
    Row& row = rows.emplace_back(Row{fmt::format("`{}`", topology)});
    for (const char* poisson : {"0.3", kOneThird})
      row.push_back(figure_text(
          median_best_error(fits(50, Fit::levenberg_marquardt, {.topology = topology, .poisson = poisson})), kDigits));
  }
  return docs::markdown_table(rows);
}

void rewrite(const char* page) {
  std::string text = docs::with_marked_table(read_file(page, "page"), docs::paper_study("fig12"), iterations_table());
  replace_file(
      page, docs::with_marked_table(std::move(text), docs::paper_study("fig12") + ", its springs", topologies_table()));
}

}  // namespace

}  // namespace nodal::paper

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: figure12 PAGE\n", stderr);
    return 2;
  }
  try {
    nodal::paper::rewrite(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure12: %s\n", error.what());
    return 2;
  }
}
