// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What an evaluator that had no part in the race says of the best point, when the trial is over: another
/// factorization, refined, and a gradient there.

#include <optional>
#include <span>
#include <string>

#include <nodal/record.h>

namespace nodal {

struct IndependentLook {
  std::optional<AuditRecord> record;  ///< empty where the fresh evaluator has no answer: the trial's own audit says why
  std::string refuted;                ///< what it says against the cost that the race has seen; empty ordinarily
};

/// Cost     an evaluator, a refined evaluation, a value and a gradient.
[[nodiscard]] IndependentLook look_independently(const Problem& problem, std::span<const double> x, double seen);

}  // namespace nodal
