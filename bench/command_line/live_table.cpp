// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_table.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include <nodal/shown.h>

#include "report/table_notes.h"

namespace nodal {

namespace {

constexpr std::size_t kFigures = 34;  // columns after the label

}  // namespace

LiveTable::LiveTable(const std::vector<std::string>& optimizers) {
  for (const std::string& optimizer : optimizers) rows_.push_back({optimizer, {}});
}

void LiveTable::add(const TrialRecord& record) {
  const auto row = std::ranges::find(rows_, record.optimizer, &Row::optimizer);
  if (row == rows_.end()) return;
  problem_ = record.problem;
  Best& best = row->by_problem[record.problem];
  ++best.trials;
  best.failed += is_failure(record.end);
  if (!record.best) return;
  const PointSummary& summary = record.best->summary;
  relative_ = summary.relative_error.has_value();
  const std::optional<double> error = relative_ ? summary.relative_error : summary.quality;
  if (!error || (best.found && best.error <= *error)) return;
  best.error = *error;
  best.found = true;
}

std::vector<std::string> LiveTable::lines(std::size_t width, std::size_t height) const {
  if (problem_.empty() || rows_.size() + 1 > height || width < kFigures + 8) return {};
  const std::size_t labels = width - kFigures;
  std::size_t widest = 9;
  for (const Row& row : rows_) widest = std::max(widest, std::min(labels, printable(row.optimizer).size()));
  const auto line = [&](const std::string& label, const std::string& error, const std::string& trials,
                        const std::string& failed) {
    return fmt::format("{:<{}.{}} {:>14} {:>8} {:>8}", label, widest, widest, error, trials, failed);
  };
  std::vector<std::string> lines = {
      line(beginning(printable(problem_), widest), relative_ ? "relative error" : "quality", "trials", "failed")};
  for (const Row& row : rows_) {
    const auto found = row.by_problem.find(problem_);
    const Best best = found == row.by_problem.end() ? Best() : found->second;
    lines.push_back(line(printable(row.optimizer), best.found ? figure_text(best.error, report::kDigits) : "–",
                         std::to_string(best.trials), best.failed > 0 ? std::to_string(best.failed) : ""));
  }
  return lines;
}

}  // namespace nodal
