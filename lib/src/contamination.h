// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Parts of what makes a trial's times worthless (record.h).

#include <nodal/record.h>

namespace nodal {

/// A core that takes this many times its least for the calibration is too slow to compare what ran on it, [1]. About
/// what a trial may lose to others by its share of a core; a quiet one keeps within 1.05.
inline constexpr double kLargestPace = 1.15;

/// It got less of a core than counts; of those too short for the system's accounts, if the core was taken from it.
[[nodiscard]] bool shared_its_core(const TrialRecord& record);

}  // namespace nodal
