// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a trial's search is made of: its random numbers, its limits, its method made afresh.

#include <cstdint>
#include <span>
#include <string>

#include <nodal/optimizer.h>
#include <nodal/trial.h>

namespace nodal {

/// Names a stream of random numbers by what it is for.
[[nodiscard]] std::uint64_t stream_key(const Study& study, const std::string& problem, const std::string& purpose,
                                       int repeat);
/// Of the trial's stream; below 2^53, so that every JSON reader keeps it.
[[nodiscard]] std::uint64_t trial_seed(const Study& study, const Trial& trial);
[[nodiscard]] Limits trial_limits(const Study& study);

/// Makes the trial's method and lets it search from `start`, to the trial's target. An exception must not lose what the
/// meter has seen: it ends the search with a failed outcome.
[[nodiscard]] Outcome search(const Study& study, const Trial& trial, const Registry& registry, Meter& meter,
                             std::span<const double> start);

}  // namespace nodal
