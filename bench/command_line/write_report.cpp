// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_report.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include <nodal/study.h>

#include "console.h"
#include "report/plates.h"
#include "report/report.h"

namespace nodal {

namespace {

constexpr std::size_t kPlainWidth = 160;         // where stdout is no terminal
constexpr std::size_t kMostPlateSprings = 4000;  // a picture of more is grey, and the page grows by megabytes

std::size_t table_width() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  return kPlainWidth;
}

// The study that a store was written for, its problems built again.
Study study_of(const Store& store, const Registry& registry) {
  const Value& study = store.manifest().at("study");
  const std::filesystem::path path =
      std::filesystem::path(study.at("directory").text()) / std::filesystem::path(study.at("file").text()).filename();
  return parse_study(study.at("text").text(), path, registry);
}

void add_plates(const Study& study, report::ReportData& data) {
  for (const StudyProblem& problem : study.problems) {
    const auto* elastic = dynamic_cast<const elastic::ElasticProblem*>(problem.problem.get());
    if (!elastic || elastic->net().springs.size() > kMostPlateSprings) continue;
    const bool drawn =
        std::ranges::any_of(data.plates, [&](const report::Plate& p) { return p.problem == problem.label; });
    const auto own = std::ranges::find_if(
        data.problems, [&](const report::ProblemReport& p) { return p.table.reference.label == problem.label; });
    if (drawn || own == data.problems.end()) continue;
    for (report::Plate& plate : report::make_plates(*elastic, *own)) data.plates.push_back(std::move(plate));
  }
}

}  // namespace

void write_report(std::span<const Store> stores, const Registry& registry, Store& target) {
  report::ReportData data = report::collect(stores);
  for (const Store& store : stores) {
    try {
      add_plates(study_of(store, registry), data);
    } catch (const std::exception& error) {
      data.warnings.push_back(fmt::format("no pictures for '{}': {}", store.directory().string(), error.what()));
      say("warning", data.warnings.back());
    }
  }
  // Files first: whoever reads the table may go away, or have no room for it.
  target.write_file("summary.csv", report::summary_csv(data));
  target.write_file("report.html", report::report_html(data));
  std::cout << report::console_table(data, table_width()) << std::flush;
  std::cerr << fmt::format("report: {}\n", (target.directory() / "report.html").string());
}

}  // namespace nodal
