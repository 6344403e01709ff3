// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a trial that runs again does the same.
///
/// One build on one processor gives one record, to the last bit but for what the clock says, as long as the clock
/// doesn't end the trial: then the trace of the shorter of two is the beginning of the other's. On another processor,
/// or by another build, last digits may differ.

#include <cstdint>
#include <string>

#include <nodal/record.h>

namespace nodal {

/// Relative, of qualities: what another processor or build may differ by.
inline constexpr double kAcrossMachines = 1e-9;

/// A record without what the clock says.
[[nodiscard]] TrialRecord untimed(TrialRecord record);

struct SameTrial {
  std::int64_t points = 0;       ///< of the traces, that were compared
  std::int64_t evaluations = 0;  ///< until which both went
  /// False where the clock ended one of them before there was anything to compare but the start.
  bool checked = false;
  std::string difference = {};  ///< for people, the first there is; empty where there is none
};

/// First, what the stored record says must agree with itself: its trace ends by its evaluations, and with its best, to
/// the drift that it tells of (agreement.h). Then starts and, as far as both went, traces are compared: evaluations and
/// qualities of their points, the latter within `tolerance` of themselves (0: to the last bit). Traces so long that
/// they may have been thinned, and not equally far, have only some points in common; the others must lie between these.
/// Where the clock ended neither, the rest is compared, too: all of the untimed records but their attempts; with a
/// tolerance their ends, bests and counts, since other builds may work and tell otherwise.
/// `timed`: the study's budget has seconds. Without, unequal evaluations are a difference.
[[nodiscard]] SameTrial same_trial(const TrialRecord& stored, const TrialRecord& again, double tolerance, bool timed);

}  // namespace nodal
