// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// Of trials only some count, `kept`, none of which failed: these and, evenly spread over the others, as many that
/// failed as keep the share of failures. All failures where nothing else is. In the order of the trials.
[[nodiscard]] std::vector<const TrialRecord*> with_failed_share(std::span<const TrialRecord* const> trials,
                                                                std::span<const TrialRecord* const> kept);

}  // namespace nodal
