// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What `nodal fit` says of a fit under what was held out.

#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// A line each: which point a validated stop chose, the unseen error there and at the start. None where nothing is held
/// out, or what is can't be evaluated.
[[nodiscard]] std::vector<std::string> unseen_lines(const TrialRecord& record);

}  // namespace nodal
