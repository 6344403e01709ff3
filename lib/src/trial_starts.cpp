// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_starts.h"

#include <set>

namespace nodal {

TrialStarts::TrialStarts(std::span<const TrialRecord* const> of_problem) {
  std::set<double> distinct;
  for (const TrialRecord* trial : of_problem) {
    if (!trial->start.quality) continue;
    by_repeat_.emplace(trial->repeat, *trial->start.quality);
    distinct.insert(*trial->start.quality);
  }
  if (distinct.size() == 1) only_ = *distinct.begin();
}

std::optional<double> TrialStarts::of(const TrialRecord& trial) const {
  if (trial.start.quality) return trial.start.quality;
  const auto found = by_repeat_.find(trial.repeat);
  return found == by_repeat_.end() ? only_ : std::optional(found->second);
}

}  // namespace nodal
