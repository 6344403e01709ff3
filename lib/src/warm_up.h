// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The beginning of a trial, run and thrown away before it.
///
/// A forked process meets the program's pages one by one, looks its libraries' functions up, and fills caches: the
/// first run of a method takes up to several times as long as its third, and not every method equally much. So the same
/// method takes its first evaluations at the same start once before, with its own evaluator, meter and numbers.

#include <optional>
#include <vector>

#include <nodal/trial.h>

namespace nodal {

struct WarmUp {
  double seconds = 0.0;  ///< wall time of it
  std::vector<TracePoint> trace;
};

/// Takes at most 300 of the trial's evaluations and 20 ms, or 5 % of its seconds where that is less, as soon as the
/// method asks whether it is spent. Whatever goes wrong is left for the trial to say.
[[nodiscard]] WarmUp warm_up(const Study& study, const Trial& trial, const Registry& registry);

/// Time to the last better point that both have seen, over the trial's own. Empty where there is none, or it came so
/// soon that the clock can't tell.
[[nodiscard]] std::optional<double> times_as_cold(const WarmUp& before, const TrialRecord& record);

}  // namespace nodal
