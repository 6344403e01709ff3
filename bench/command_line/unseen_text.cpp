// SPDX-License-Identifier: GPL-3.0-or-later
#include "unseen_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/number_text.h>

namespace nodal {

namespace {

constexpr int kDigits = 4;

std::string stop_text(const UnseenRecord& unseen) {
  std::vector<std::string> choosing;
  for (std::size_t i = 0; i < unseen.names.size(); ++i)
    if (!unseen.reports(i)) choosing.push_back(unseen.names[i]);
  return fmt::format("chosen by {}: the point of evaluation {}; the race went on to quality {} at evaluation {}",
                     fmt::join(choosing, ", "), unseen.stop->evaluation,
                     figure_text(unseen.stop->fitted_quality, kDigits), unseen.stop->fitted_evaluation);
}

std::string error_text(const UnseenRecord& unseen, const UnseenPoint& point) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < unseen.names.size(); ++i)
    if (unseen.reports(i)) each.push_back(unseen.names[i] + " " + figure_text(point.errors[i], kDigits));
  const UnseenPoint* start = unseen.at(0);
  return fmt::format("unseen error {}{}; of what was never fitted: {}", figure_text(unseen.error(point), kDigits),
                     start ? fmt::format(" (at the start {})", figure_text(unseen.error(*start), kDigits)) : "",
                     fmt::join(each, ", "));
}

}  // namespace

std::vector<std::string> unseen_lines(const TrialRecord& record) {
  std::vector<std::string> lines;
  if (!record.unseen || !record.best) return lines;
  if (record.unseen->stop) lines.push_back(stop_text(*record.unseen));
  if (const UnseenPoint* point = record.unseen->at(record.best->evaluation))
    lines.push_back(error_text(*record.unseen, *point));
  return lines;
}

}  // namespace nodal
