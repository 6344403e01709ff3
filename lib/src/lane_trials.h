// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Trials that ran beside others and run once more, alone, for their times.

#include <string>
#include <vector>

#include <nodal/store.h>
#include <nodal/trial.h>

namespace nodal {

/// Of each optimizer on each problem as many as it lacks of `wanted` trials that ran alone, evenly spread over its
/// repeats; trials that failed tell no times. In the order of all trials, so that every optimizer meets the same
/// moments.
[[nodiscard]] std::vector<Trial> lane_trials(const Study& study, const Store& store, int wanted);

/// What two runs of one trial that the clock didn't end disagree on, for people; empty where there is nothing.
[[nodiscard]] std::string lane_difference(const Study& study, const TrialRecord& beside, const TrialRecord& alone);

}  // namespace nodal
