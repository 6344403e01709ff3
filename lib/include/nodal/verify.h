// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a trial that runs again does the same.
///
/// One build on one processor gives one trace, to the last bit, as long as the clock doesn't end it: then the shorter
/// of two is the beginning of the other. On another processor, or by another build, last digits may differ.

#include <cstdint>
#include <string>

#include <nodal/record.h>

namespace nodal {

/// Relative, of qualities: what another processor or build may differ by.
inline constexpr double kAcrossMachines = 1e-9;

struct SameTrial {
  std::int64_t points = 0;       ///< of the traces, that were compared
  std::int64_t evaluations = 0;  ///< until which both went
  std::string difference = {};   ///< for people, the first there is; empty where there is none
};

/// Compares traces as far as both went: evaluations and qualities of their points, the latter within `tolerance` of
/// themselves (0: to the last bit), then, where both went equally far, how they ended. Traces so long that they were
/// thinned, and not equally far, have only some points in common, which are compared.
[[nodiscard]] SameTrial same_trial(const TrialRecord& stored, const TrialRecord& again, double tolerance);

}  // namespace nodal
