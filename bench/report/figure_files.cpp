// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "chart/svg_chart.h"
#include "race_chart.h"

namespace nodal::report {

namespace {

constexpr std::size_t kLongestStem = 80;

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
  for (const Axis axis : axes_of(problem))
    files.push_back(
        {fmt::format("{}-{}.svg", stem, axis_name(axis)), svg_chart_file(race_chart(problem, raced, axis))});
}

}  // namespace

std::vector<FigureFile> figure_files(const ReportData& data) {
  std::vector<FigureFile> files;
  std::set<std::string> taken;
  for (const ProblemReport& problem : data.problems) {
    const std::string stem = stem_of(problem.table.reference.label, taken);
    if (!problem.curves.empty()) add(problem, Raced::quality, stem + "-error", files);
    if (!problem.curves.empty() && has_gap(problem)) add(problem, Raced::gap, stem + "-gap", files);
    if (!problem.unseen_curves.empty()) add(problem, Raced::unseen, stem + "-unseen", files);
  }
  return files;
}

}  // namespace nodal::report
