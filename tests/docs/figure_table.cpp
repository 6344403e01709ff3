// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include <nodal/unseen.h>

#include "marked_table.h"

namespace nodal::docs {

namespace {

constexpr int kDigits = 3;
constexpr PrintedFigure kPrinted[] = {
    {"fig08", "G_{1:6:18}", 2.8, 0.55}, {"fig09", "G_{1:3:15}", 2.3, 0.6}, {"fig10", "G_{1:3:15}", 10.5, 0.48}};

using Row = std::vector<std::string>;

std::string text(const std::optional<double>& figure) { return figure ? figure_text(*figure, kDigits) : "–"; }

std::string spread(const Quartiles& q) {
  const std::string median = text(q.median), lower = text(q.lower), upper = text(q.upper);
  return lower == upper ? median : fmt::format("{} [{}, {}]", median, lower, upper);
}

Row start_row(const ProblemTable& table) {
  return {"**" + table.reference.label + "**",
          text(table.start_quality),
          "",
          "",
          table.unseen ? text(table.unseen->start) : "–",
          "",
          ""};
}

Row row_of(const OptimizerRow& row, const std::optional<double>& start) {
  const auto unseen = row.findings.find(kUnseenFinding);
  return {row.label + (row.baseline ? fmt::format(" (baseline, {} runs)", row.trials) : ""),
          "",
          row.quality ? spread(*row.quality) : "–",
          row.quality && start ? text(*start / row.quality->median) : "–",
          "",
          unseen == row.findings.end() ? "–" : text(unseen->second.median),
          row.evaluations ? count_text(row.evaluations->median) : "–"};
}

struct Curve {
  const char* key;
  const char* name;
  double unit;
};
// The energy of regular hexagons is 5/(36√3).
const Curve kCurves[] = {{"distance_deviation", "distances between neighbours", 1.0},
                         {"area_deviation", "areas of regions", 1.0},
                         {"energy", "energy", 5.0 / (36.0 * std::sqrt(3.0))}};

}  // namespace

std::optional<PrintedFigure> printed_figure(const std::string& study) {
  const auto found = std::ranges::find_if(kPrinted, [&](const PrintedFigure& f) { return f.study == study; });
  return found == std::end(kPrinted) ? std::nullopt : std::optional(*found);
}

std::string figure_table(const report::ReportData& data) {
  std::vector<Row> rows = {{"", "G before", "after", "before / after", "unseen error before", "after", "evaluations"}};
  if (const auto printed = printed_figure(data.study_name))
    rows.push_back({fmt::format("**the paper, {}**", printed->quality), fmt::format("{}", printed->before),
                    fmt::format("{}", printed->after), text(printed->ratio()), "", "", ""});
  for (const report::ProblemReport& problem : data.problems) {
    rows.push_back(start_row(problem.table));
    for (const OptimizerRow& row : problem.table.rows) rows.push_back(row_of(row, problem.table.start_quality));
  }
  return markdown_table(rows);
}

std::string errors_table(const report::ReportData& data) {
  std::vector<Row> rows = {{""}};
  for (const report::ProblemReport& problem : data.problems) {
    rows[0].push_back(problem.table.reference.label);
    for (const OptimizerRow& row : problem.table.rows) {
      auto own = std::ranges::find_if(rows, [&](const Row& r) { return r[0] == row.label; });
      if (own == rows.end()) own = rows.insert(rows.end(), Row{row.label});
      own->resize(rows[0].size() - 1, "–");
      own->push_back(row.relative_error ? spread(*row.relative_error) : "–");
    }
  }
  for (Row& row : rows) row.resize(rows[0].size(), "–");
  return markdown_table(rows);
}

std::string voronoi_table(const Value& manifest) {
  constexpr std::size_t kShown[] = {0, 1, 5, 15, 50};
  std::vector<Row> rows = {{"iterations"}};
  for (const std::size_t iterations : kShown) rows[0].push_back(std::to_string(iterations));
  for (const Value& problem : manifest.at("problems").list()) {
    rows.emplace_back(rows[0].size())[0] = "**" + problem.at("label").text() + "**";
    const Value::List& history = problem.at("details").at("voronoi").list();
    for (const Curve& curve : kCurves) {
      Row& row = rows.emplace_back(Row{curve.name});
      for (const std::size_t iterations : kShown)
        row.push_back(fmt::format("{:.3f}", history.at(iterations).at(curve.key).number() / curve.unit));
    }
  }
  return markdown_table(rows);
}

}  // namespace nodal::docs
