// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A trial as its clock needs it.

#include <optional>

#include <nodal/trial.h>

namespace nodal {

/// `run_trial` after its warm-up, on one core where one is given. The record's conditions have what only the trial's
/// own process knows: the core, its context switches, how much slower it began cold. For a process of the trial's own.
[[nodiscard]] TrialRecord run_clocked_trial(const Study& study, const Trial& trial, const Registry& registry,
                                            std::optional<int> core);

}  // namespace nodal
