// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How a trial's points do on what the problem holds out (Problem::held_out): measured after the trial at the points
/// that the meter kept (kept_points.h), so that it is in none of its times and counts.
///
/// The unseen error is the root mean square of the held-out errors. Under a validated stop every second of what is held
/// out, from the first on, chooses the point that is reported; the others report.
///
/// Units    errors are relative: 0 is perfect, 1 as bad as doing nothing.
/// Threads  plain values.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/kept_points.h>

namespace nodal {

struct FindingDescription;  // command.h

/// √(mean of squares) of the relative errors in what is held out; 0 of none.
[[nodiscard]] double unseen_error(std::span<const double> errors);

struct UnseenPoint {
  TracePoint at;               ///< as the race saw it
  std::vector<double> errors;  ///< [names]
};

/// What a validated stop chose.
struct ValidatedStop {
  std::int64_t evaluation = 0;         ///< of the point that is reported
  std::int64_t fitted_evaluation = 0;  ///< of the best of the whole race …
  double fitted_quality = 0.0;         ///< … and what the race saw there
};

struct UnseenRecord {
  std::vector<std::string> names;
  /// The start, points in between, the best of the race, by evaluation; fewer where a point is not to be evaluated.
  std::vector<UnseenPoint> points;
  std::int64_t failed = 0;  ///< points that are left out for that
  std::optional<ValidatedStop> stop;

  /// [names] Whether an error reports; all of them without a validated stop.
  [[nodiscard]] bool reports(std::size_t name) const noexcept { return !stop || name % 2 == 1; }
  /// unseen_error of what reports.
  [[nodiscard]] double error(const UnseenPoint& point) const;
  /// The same of what chooses under a validated stop.
  [[nodiscard]] double choosing_error(const UnseenPoint& point) const;
  /// Of what reports, the name with the largest error. There is one.
  [[nodiscard]] std::size_t worst(const UnseenPoint& point) const;
  /// The point of an evaluation; none where it was left out.
  [[nodiscard]] const UnseenPoint* at(std::int64_t evaluation) const;
};

/// The finding under which a record's health has the unseen error of its best point. No problem may have one of its own
/// by that name.
inline constexpr const char* kUnseenFinding = "unseen";
[[nodiscard]] FindingDescription unseen_finding();

class Problem;
struct TrialRecord;

/// Why a problem takes no validated stop: it needs two things that are held out. Empty when it does.
[[nodiscard]] std::string validated_stop_refusal(const Problem& problem);

/// An unseen error that is larger than its least on the way by less than this is scatter.
inline constexpr double kRisenUnseen = 1.25;

/// What should be known of a trial's unseen errors, in words with their figures: larger than at the start, more than
/// three times the fitted error, or larger than on the way. Empty when there is nothing.
[[nodiscard]] std::string unseen_warning(const TrialRecord& record);

}  // namespace nodal
