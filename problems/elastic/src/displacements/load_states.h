// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What becomes of loads at solved equilibria, for people: displacements, forces of springs and supports, errors.

#include <span>
#include <vector>

#include <nodal/elastic/state.h>

#include "displacements/full_evaluation.h"

namespace nodal::elastic {

/// Of a solve of the model that was ok, at these stiffnesses.
[[nodiscard]] std::vector<LoadState> load_states(const ElasticModel& model, const FullEvaluation& evaluation,
                                                 std::span<const double> stiffness);

/// Solves the model of the loads that are held out, and tells the state how they fare, or why that can't be said.
void add_unseen(const ElasticModel& model, std::span<const double> stiffness, State& state);

}  // namespace nodal::elastic
