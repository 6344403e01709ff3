// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The tables in docs/reproduction.md that comparisons of bench/scenes/paper/ make.

#include <optional>
#include <string>
#include <vector>

#include <report/report_data.h>

namespace nodal::docs {

/// What the paper prints below a figure.
struct PrintedFigure {
  const char* study;  ///< its name: "fig08"
  const char* quality;
  double before, after;

  [[nodiscard]] double ratio() const { return before / after; }
};

/// Of a study that fits one of the paper's figures; nothing of others.
[[nodiscard]] std::optional<PrintedFigure> printed_figure(const std::string& study);

/// G before and after, its ratio, unseen errors: the paper's row, then of every problem the start and each optimizer.
[[nodiscard]] std::string figure_table(const report::ReportData& data);

/// Relative errors of every optimizer, median and quartiles, a column per problem.
[[nodiscard]] std::string errors_table(const report::ReportData& data);

/// Figure 2 from a store's manifest: of each problem what its points are like after 0, 1, 5, 15 and 50 iterations.
[[nodiscard]] std::string voronoi_table(const Value& manifest);

}  // namespace nodal::docs
