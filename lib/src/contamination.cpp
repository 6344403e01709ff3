// SPDX-License-Identifier: GPL-3.0-or-later
#include "contamination.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nodal {

bool shared_its_core(const TrialRecord& record) {
  const Seconds& seconds = record.seconds;
  if (record.end == End::timeout && seconds.cpu == 0.0) return false;  // nobody knows: it was killed
  if (seconds.cpu >= kLeastCoreShare * seconds.total) return false;
  return seconds.total >= kShortestToldSeconds || (record.conditions && record.conditions->preempted.value_or(0) > 0);
}

std::string contamination(const TrialRecord& record) {
  std::vector<std::string> reasons;
  if (record.conditions) {
    const Conditions& at = *record.conditions;
    if (at.stopped) reasons.emplace_back("was stopped while it ran");
    if (at.jobs > at.cores)
      reasons.push_back(fmt::format("{} jobs shared {} core{}", at.jobs, at.cores, at.cores == 1 ? "" : "s"));
    if (at.beside_others) reasons.emplace_back("another comparison ran beside it");
    if (at.pace && *at.pace > kLargestPace)
      reasons.push_back(fmt::format("ran when its core was {:.2f} times as slow as at its fastest", *at.pace));
  }
  if (shared_its_core(record))
    reasons.push_back(fmt::format("got {:.2f} of a core", record.seconds.cpu / record.seconds.total));
  return fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace nodal
