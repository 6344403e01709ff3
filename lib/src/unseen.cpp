// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/unseen.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/command.h>
#include <nodal/problem.h>
#include <nodal/record.h>
#include <nodal/show/number_text.h>

namespace nodal {

namespace {

constexpr double kManyTimes = 3.0;  // the fitted error
constexpr int kErrorDigits = 3;

template <class Counts>
double error_of_those(const std::vector<double>& errors, Counts counts) {
  std::vector<double> counted;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (counts(i)) counted.push_back(errors[i]);
  return unseen_error(counted);
}

std::string text(double error) { return figure_text(error, kErrorDigits); }

}  // namespace

double unseen_error(std::span<const double> errors) {
  double sum = 0.0;
  for (const double error : errors) sum += error * error;
  return errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors.size()));
}

double UnseenRecord::error(const UnseenPoint& point) const {
  return error_of_those(point.errors, [this](std::size_t i) { return reports(i); });
}

double UnseenRecord::choosing_error(const UnseenPoint& point) const {
  return error_of_those(point.errors, [](std::size_t i) { return i % 2 == 0; });
}

std::size_t UnseenRecord::worst(const UnseenPoint& point) const {
  std::size_t worst = names.size();
  for (std::size_t i = 0; i < point.errors.size(); ++i)
    if (reports(i) && (worst == names.size() || point.errors[i] > point.errors[worst])) worst = i;
  return worst;
}

const UnseenPoint* UnseenRecord::at(std::int64_t evaluation) const {
  const auto found = std::ranges::find(points, evaluation, [](const UnseenPoint& p) { return p.at.evaluation; });
  return found == points.end() ? nullptr : &*found;
}

FindingDescription unseen_finding() {
  return {.name = kUnseenFinding,
          .title = "unseen error",
          .help = "root mean square of the relative errors in what is held out: measured after a trial, never fitted",
          .tabled = true};
}

std::string validated_stop_refusal(const Problem& problem) {
  const std::size_t count = problem.held_out().size();
  if (count >= 2) return {};
  return fmt::format(
      "{} held out, and a validated stop needs two at least: every second one chooses the point, the "
      "others report",
      count == 0 ? "nothing is" : fmt::format("only '{}' is", problem.held_out().front()));
}

std::string unseen_warning(const TrialRecord& record) {
  if (!record.unseen || !record.best) return {};
  const UnseenRecord& unseen = *record.unseen;
  const UnseenPoint* best = unseen.at(record.best->evaluation);
  const UnseenPoint* start = unseen.at(0);
  if (!best) return {};
  const double error = unseen.error(*best);
  std::vector<std::string> reasons;
  if (start && error > unseen.error(*start)) reasons.push_back("above the start's " + text(unseen.error(*start)));
  const std::optional<double>& fitted = record.best->summary.relative_error;
  if (fitted && *fitted > 0.0 && error > kManyTimes * *fitted)
    reasons.push_back(fmt::format("{:.3g} times the fitted error", error / *fitted));
  const auto least =
      std::ranges::min_element(unseen.points, {}, [&](const UnseenPoint& point) { return unseen.error(point); });
  const bool on_the_way = 0 < least->at.evaluation && least->at.evaluation < best->at.evaluation;
  if (on_the_way && error > kRisenUnseen * unseen.error(*least))
    reasons.push_back(fmt::format("and it was least, {}, at evaluation {}: it rose while the fitted error fell",
                                  text(unseen.error(*least)), least->at.evaluation));
  if (reasons.empty()) return {};
  return fmt::format("unseen error {} (worst: {} {}), {}", text(error), unseen.names[unseen.worst(*best)],
                     text(best->errors[unseen.worst(*best)]), fmt::join(reasons, ", "));
}

}  // namespace nodal
