// SPDX-License-Identifier: GPL-3.0-or-later
#include "failed_share.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace nodal {

std::vector<const TrialRecord*> with_failed_share(std::span<const TrialRecord* const> trials,
                                                  std::span<const TrialRecord* const> kept) {
  std::vector<const TrialRecord*> failed;
  std::ranges::copy_if(trials, std::back_inserter(failed),
                       [](const TrialRecord* trial) { return is_failure(trial->end); });
  const std::size_t others = trials.size() - failed.size();
  const double share = others == 0 ? 1.0 : static_cast<double>(kept.size()) / static_cast<double>(others);
  const auto count = static_cast<std::size_t>(std::lround(share * static_cast<double>(failed.size())));
  std::set<const TrialRecord*> chosen(kept.begin(), kept.end());
  for (std::size_t i = 0; i < count; ++i) chosen.insert(failed[i * failed.size() / count]);
  std::vector<const TrialRecord*> all;
  std::ranges::copy_if(trials, std::back_inserter(all),
                       [&](const TrialRecord* trial) { return chosen.contains(trial); });
  return all;
}

}  // namespace nodal
