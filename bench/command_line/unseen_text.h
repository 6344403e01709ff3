// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What `nodal fit` says of a fit under what was held out.

#include <string>
#include <vector>

#include <nodal/problem.h>
#include <nodal/record.h>

namespace nodal {

/// A line each: that what is held out can't be evaluated everywhere, which point a validated stop chose, the unseen
/// error there and at the start. None where nothing is held out. `validated`: a stop was asked for.
[[nodiscard]] std::vector<std::string> unseen_lines(const TrialRecord& record, bool validated);
/// What is to be known of it, and what helps: what the problem says, and a validated stop where it can be had.
[[nodiscard]] std::string unseen_note(const TrialRecord& record, const Problem& problem, bool validated);

}  // namespace nodal
