// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/record.h>

namespace nodal {

std::string contamination(const TrialRecord& record) {
  std::vector<std::string> reasons;
  if (record.conditions) {
    const Conditions& at = *record.conditions;
    if (at.stopped) reasons.emplace_back("was stopped while it ran");
    if (at.jobs > at.cores)
      reasons.push_back(fmt::format("{} jobs shared {} core{}", at.jobs, at.cores, at.cores == 1 ? "" : "s"));
    if (at.beside_others) reasons.emplace_back("another comparison ran beside it");
  }
  const Seconds& seconds = record.seconds;
  if (seconds.total >= kShortestToldSeconds && seconds.cpu < kLeastCoreShare * seconds.total)
    reasons.push_back(fmt::format("got {:.2f} of a core", seconds.cpu / seconds.total));
  return fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace nodal
