// SPDX-License-Identifier: GPL-3.0-or-later
#include "unseen_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/exhibit.h>
#include <nodal/show/number_text.h>

#include "report/table_notes.h"

namespace nodal {

namespace {

// Relative errors go with qualities, but for a prior's share.
std::string fitted_text(const TrialRecord& record) {
  const double quality = record.unseen->stop->fitted_quality;
  const PointSummary& chosen = record.best->summary;
  if (chosen.relative_error && chosen.quality && *chosen.quality > 0.0 && !chosen.data_quality)
    return "relative error " + figure_text(*chosen.relative_error * quality / *chosen.quality, report::kDigits);
  return "quality " + figure_text(quality, report::kDigits);
}

std::string stop_text(const TrialRecord& record) {
  const UnseenRecord& unseen = *record.unseen;
  std::vector<std::string> choosing;
  for (std::size_t i = 0; i < unseen.names.size(); ++i)
    if (!unseen.reports(i)) choosing.push_back(unseen.names[i]);
  return fmt::format("chosen by {}: the point of evaluation {}; the race went on to {} at evaluation {}",
                     fmt::join(choosing, ", "), unseen.stop->evaluation, fitted_text(record),
                     unseen.stop->fitted_evaluation);
}

std::string missing_text(const UnseenRecord& unseen, bool validated) {
  const std::size_t all = unseen.points.size() + static_cast<std::size_t>(unseen.failed);
  return fmt::format("what is held out can't be evaluated at {} of {} points that were looked at{}", unseen.failed, all,
                     validated && !unseen.stop ? ", so nothing could be chosen: the best of the race is reported" : "");
}

std::string error_text(const UnseenRecord& unseen, const UnseenPoint& point) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < unseen.names.size(); ++i)
    if (unseen.reports(i)) each.push_back(unseen.names[i] + " " + figure_text(point.errors[i], report::kDigits));
  const UnseenPoint* start = unseen.at(0);
  return fmt::format("unseen error {}{}; of what was never fitted: {}",
                     figure_text(unseen.error(point), report::kDigits),
                     start ? fmt::format(" (at the start {})", figure_text(unseen.error(*start), report::kDigits)) : "",
                     fmt::join(each, ", "));
}

}  // namespace

std::string unseen_note(const TrialRecord& record, const Problem& problem, bool validated) {
  const std::string warning = unseen_warning(record);
  if (warning.empty()) return {};
  std::vector<std::string> helps = exhibit_of(problem)->remedies();
  if (!validated && validated_stop_refusal(problem).empty()) helps.emplace_back("a validated stop (--validate)");
  return helps.empty() ? warning : fmt::format("{}; what helps: {}", warning, fmt::join(helps, ", "));
}

std::vector<std::string> unseen_lines(const TrialRecord& record, bool validated) {
  std::vector<std::string> lines;
  if (!record.unseen || !record.best) return lines;
  if (record.unseen->failed > 0) lines.push_back(missing_text(*record.unseen, validated));
  if (record.unseen->stop) lines.push_back(stop_text(record));
  if (const UnseenPoint* point = record.unseen->at(record.best->evaluation))
    lines.push_back(error_text(*record.unseen, *point));
  return lines;
}

}  // namespace nodal
