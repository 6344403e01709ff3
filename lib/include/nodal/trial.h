// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One run: study × problem × optimizer × repeat. `run_trial` is a pure function of its arguments (but for seconds):
/// child processes, resuming and verification all rest on that.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/record.h>
#include <nodal/study.h>

namespace nodal {

/// Indices into a study.
struct Trial {
  std::size_t problem = 0;
  std::size_t optimizer = 0;
  int repeat = 0;
};

/// Every trial of a study, problem by problem, repeat by repeat, so that an early stop leaves complete repeats.
/// A deterministic method from the initial start runs min(3, repeats) times, for its time only.
[[nodiscard]] std::vector<Trial> all_trials(const Study& study);

/// Names a trial by what determines its outcome: hash of the resolved problem, `use`, effective options, budget, seed,
/// start and repeat. Labels count only through the seed.
[[nodiscard]] std::string trial_key(const Study& study, const Trial& trial);

/// The point at which a trial starts: the problem's start, or under `starts = "sampled"` and repeat > 0 a point drawn
/// from (study seed, problem label, repeat), the same for every optimizer.
[[nodiscard]] std::vector<double> trial_start(const Study& study, const Trial& trial);

/// The quality that ends a trial (gap ≤ target_gap), given the quality at its start; −∞ without a target.
/// A start that is as good as the best known, to the digits that this is given with, is there.
[[nodiscard]] double target_quality(const Study& study, const Trial& trial, double start_quality);

/// Runs it in this thread. Fresh evaluator, meter and optimizer. Exceptions become a record with end `failed`.
[[nodiscard]] TrialRecord run_trial(const Study& study, const Trial& trial, const Registry& registry);

/// The record of a trial whose process was killed (`timeout`) or died (`crashed`).
[[nodiscard]] TrialRecord lost_trial(const Study& study, const Trial& trial, End end, const std::string& reason);

}  // namespace nodal
