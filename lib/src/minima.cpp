// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/minima.h>

#include <algorithm>
#include <cmath>

#include <nodal/agreement.h>

namespace nodal {

namespace {

double quality_of(const TrialRecord* trial) { return *trial->best->summary.quality; }

bool perfect(const TrialRecord& trial) {
  return trial.best->summary.cost && std::abs(*trial.best->summary.cost) <= kPerfectCost;
}

// Over pairs it is the largest extent along a coordinate.
double width_of(const std::vector<const TrialRecord*>& trials) {
  double width = 0.0;
  const std::size_t coordinates = trials.front()->best->x.size();
  for (std::size_t i = 0; i < coordinates; ++i) {
    double low = trials.front()->best->x[i], high = low;
    for (const TrialRecord* trial : trials) {
      if (trial->best->x.size() != coordinates) continue;
      low = std::min(low, trial->best->x[i]);
      high = std::max(high, trial->best->x[i]);
    }
    width = std::max(width, high - low);
  }
  return width;
}

bool one_minimum(double lower, double upper) { return upper - lower <= kOneMinimum * std::abs(upper); }

}  // namespace

Minima minima(std::span<const TrialRecord* const> trials) {
  Minima result;
  std::vector<const TrialRecord*> arrived;
  for (const TrialRecord* trial : trials) {
    const bool seen = trial->best && trial->best->summary.quality && !is_failure(trial->end);
    if (seen && perfect(*trial))
      arrived.push_back(trial);
    else if (!seen || !trial->audit || !trial->audit->stationarity)
      ++result.unknown;
    else
      (*trial->audit->stationarity <= kArrived ? arrived : result.on_the_way).push_back(trial);
  }
  std::ranges::stable_sort(arrived, {}, quality_of);
  for (const TrialRecord* trial : arrived) {
    // All perfect fits are one, whatever the rounding that they are of.
    const bool joins =
        !result.found.empty() && ((perfect(*trial) && perfect(*result.found.back().trials.back())) ||
                                  one_minimum(quality_of(result.found.back().trials.back()), quality_of(trial)));
    if (!joins) result.found.push_back({.quality = quality_of(trial)});
    result.found.back().trials.push_back(trial);
  }
  for (Minimum& minimum : result.found) minimum.width = width_of(minimum.trials);
  return result;
}

}  // namespace nodal
