// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "chart/svg_chart.h"
#include "convergence_charts.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

constexpr std::size_t kLongestStem = 80;
constexpr std::string_view kFigureFileStart = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"lines\"";

std::string stem_of(const std::string& label, std::set<std::string>& taken) {
  std::string stem;
  for (const char c : label.substr(0, kLongestStem))
    stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '-';
  if (stem.empty()) stem = "problem";
  std::string one = stem;
  for (int number = 2; !taken.insert(one).second; ++number) one = fmt::format("{}-{}", stem, number);
  return one;
}

void add(const ProblemReport& problem, Raced raced, const std::string& stem, std::vector<FigureFile>& files) {
  for (const Axis axis : problem.table.axes)
    files.push_back(
        {fmt::format("{}-{}.svg", stem, axis_name(axis)), svg_chart_file(race_chart(problem, raced, axis))});
}

void add(const ProblemReport& problem, const ProblemConvergence& convergence, const std::string& stem,
         std::vector<FigureFile>& files) {
  for (const Axis axis : problem.table.axes)
    files.push_back({fmt::format("{}-attained-{}.svg", stem, axis_name(axis)),
                     svg_chart_file(attainment_chart(problem, convergence, axis))});
}

void add(const Profiles& profiles, const std::vector<ProblemReport>& problems, const std::string& stem,
         std::vector<FigureFile>& files) {
  const ProfileCharts charts = profile_charts(profiles, problems);
  const auto name = [&](std::string_view what) {
    return fmt::format("{}-{}-{}.svg", stem, what, axis_name(profiles.axis));
  };
  files.push_back({name("data-profile"), svg_chart_file(charts.data)});
  files.push_back({name("performance-profile"), svg_chart_file(charts.performance)});
  files.push_back({name("run-lengths"), svg_chart_file(charts.reached)});
}

}  // namespace

bool is_figure_file(std::string_view text) { return text.starts_with(kFigureFileStart); }

std::vector<FigureFile> figure_files(const ReportData& data) {
  std::vector<FigureFile> files;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < data.problems.size(); ++i) {
    const ProblemReport& problem = data.problems[i];
    const std::string stem = stem_of(problem.table.reference.label, taken);
    if (!problem.curves.empty()) add(problem, Raced::quality, stem + "-error", files);
    if (!problem.curves.empty() && has_gap(problem)) add(problem, Raced::gap, stem + "-gap", files);
    if (!problem.unseen_curves.empty()) add(problem, Raced::unseen, stem + "-unseen", files);
    if (!data.convergence.empty()) add(problem, data.convergence[i], stem, files);
  }
  const std::string over_all = stem_of("all-problems", taken);
  for (const Profiles& profiles : data.profiles) add(profiles, data.problems, over_all, files);
  return files;
}

}  // namespace nodal::report
