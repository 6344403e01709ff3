// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include <nodal/analysis.h>

namespace nodal {

bool ran_alone(const TrialRecord& record) { return !record.conditions || record.conditions->jobs == 1; }

bool ran_alone_undisturbed(const TrialRecord& record) { return ran_alone(record) && contamination(record).empty(); }

std::vector<const TrialRecord*> timed_trials(std::span<const TrialRecord* const> trials) {
  std::vector<const TrialRecord*> timed;
  std::ranges::copy_if(trials, std::back_inserter(timed),
                       [](const TrialRecord* trial) { return ran_alone_undisturbed(*trial); });
  if (timed.empty()) timed.assign(trials.begin(), trials.end());
  return timed;
}

}  // namespace nodal
