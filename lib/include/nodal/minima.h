// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// At which minima trials have ended. A pure function of records.
///
/// A trial has arrived when an independent look found no slope left at its best point (AuditRecord::stationarity).
/// Those that have are put together by quality: one minimum ends where the next quality is farther away than slopes
/// leave open. Points of one quality may lie far apart, where the data leave coordinates open: `width` says how far.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// A point has arrived where the cost falls by less than this share of itself per unit of a coordinate.
inline constexpr double kArrived = 1e-3;
/// Neighbours in quality within this, relative, are one minimum.
inline constexpr double kOneMinimum = 1e-4;

struct Minimum {
  double quality = 0.0;                         ///< the least of its trials
  double width = 0.0;                           ///< the largest difference in a coordinate between its points
  std::vector<const TrialRecord*> trials = {};  ///< in the order of their qualities
};

struct Minima {
  std::vector<Minimum> found;                       ///< best first
  std::vector<const TrialRecord*> on_the_way = {};  ///< with a slope left
  std::size_t unknown = 0;                          ///< trials of which it can't be told: no best point, no gradient
};

/// Of trials of one problem. Perfect fits, which have no slope, have arrived.
/// Cost     a sort; coordinates × trials.
[[nodiscard]] Minima minima(std::span<const TrialRecord* const> trials);

}  // namespace nodal
