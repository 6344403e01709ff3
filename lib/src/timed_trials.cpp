// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include <nodal/analysis.h>

#include "failed_share.h"

namespace nodal {

bool ran_alone(const TrialRecord& record) {
  return !record.conditions || (record.conditions->jobs == 1 && !record.conditions->beside_others);
}

bool ran_alone_undisturbed(const TrialRecord& record) { return ran_alone(record) && contamination(record).empty(); }

std::vector<const TrialRecord*> timed_trials(std::span<const TrialRecord* const> trials) {
  const auto that = [trials](auto is) {
    std::vector<const TrialRecord*> found;
    std::ranges::copy_if(trials, std::back_inserter(found),
                         [is](const TrialRecord* trial) { return !is_failure(trial->end) && is(*trial); });
    return found;
  };
  std::vector<const TrialRecord*> timed = that(ran_alone_undisturbed);
  if (timed.empty()) timed = that([](const TrialRecord& trial) { return contamination(trial).empty(); });
  if (timed.empty()) return {trials.begin(), trials.end()};
  return with_failed_share(trials, timed);
}

}  // namespace nodal
