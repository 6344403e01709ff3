// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/html.h>

#include "convergence_charts.h"
#include "folded_table.h"
#include "page_parts.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

std::string shares_table(const std::string& title, const std::vector<std::string>& names, const TableRow& places,
                         const statistics::Matrix& shares) {
  TableRow head = {"optimizer"};
  head.insert(head.end(), places.begin(), places.end());
  std::vector<TableRow> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    TableRow& row = rows.emplace_back(TableRow{names[i]});
    for (const double share : shares[i]) row.push_back(share_text(share));
  }
  return folded_table(title, head, rows);
}

statistics::Matrix reached_at(const Profiles& profiles) {
  statistics::Matrix shares;
  for (const std::vector<statistics::Step>& steps : profiles.reached) {
    std::vector<double>& row = shares.emplace_back();
    for (const double cost : profiles.costs) {
      const auto later =
          std::ranges::partition_point(steps, [cost](const statistics::Step& step) { return step.at <= cost; });
      row.push_back(later == steps.begin() ? 0.0 : std::prev(later)->share);
    }
  }
  return shares;
}

}  // namespace

std::string profiles_html(const Profiles& profiles, const std::vector<ProblemReport>& problems) {
  const std::string by(axis_name(profiles.axis)), id = fmt::format("-{}", to_string(profiles.axis));
  TableRow costs, factors;
  for (const double cost : profiles.costs) costs.push_back(cost_text(cost, profiles.axis));
  for (const double factor : profiles.factors) factors.push_back(fmt::format("{:g}×", factor));
  const ProfileCharts charts = profile_charts(profiles, problems);
  std::string text = fmt::format("<details class=\"profiles\"{}><summary>By {}</summary>\n",
                                 profiles.axis == Axis::seconds ? " open" : "", by);
  text += still_figure(charts.data, "data-profile" + id,
                       shares_table("The data profile as a table", profiles.optimizers, costs, profiles.data));
  text += still_figure(
      charts.performance, "performance-profile" + id,
      shares_table("The performance profile as a table", profiles.optimizers, factors, profiles.performance));
  if (!profiles.warning.empty()) text += "<p class=\"note\">" + escape_html(profiles.warning) + "</p>\n";
  text += still_figure(charts.reached, "run-lengths" + id,
                       shares_table("The run lengths as a table", profiles.optimizers, costs, reached_at(profiles)));
  return text + "</details>\n";
}

}  // namespace nodal::report
