// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a sceptic asks of stored trials: does a method say of itself what the meter saw, are two entries one, did the
/// first repeat pay for something that the others found made?
///
/// Pure functions of records. Nothing here changes a figure: everything else counts what the meter saw.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// In how many trials something was found, and the trial where it is farthest off.
template <class Figure>
struct Sighting {
  std::size_t trials = 0;
  int repeat = 0;
  Figure claimed{}, seen{};
};

/// What the trials of an optimizer claim of themselves, against what the meter saw. A trial that claims nothing, or saw
/// no finite cost, agrees.
struct ClaimsSeen {
  std::size_t claiming = 0;      ///< trials with a claim
  Sighting<double> better;       ///< a cost that a fresh evaluation of the best point refutes (agreement.h)
  Sighting<double> worse;        ///< a cost above that of the best point it saw, by more than kSameClaim of it
  std::size_t other_points = 0;  ///< trials that return another point than the best they saw, at another cost
  /// Another count than the meter's; more is no disagreement where the meter ended the trial and refused what came
  /// then.
  Sighting<std::int64_t> evaluations;

  [[nodiscard]] bool agrees() const noexcept { return better.trials + worse.trials + evaluations.trials == 0; }
};

/// Costs closer than this, relative, are one: libraries add up in another order.
inline constexpr double kSameClaim = 1e-9;

[[nodiscard]] ClaimsSeen claims_seen(std::span<const TrialRecord* const> trials);

/// Two entries of which every repeat that both have did the same: the qualities of their traces are equal to the last
/// bit, and so are the evaluations at which they were found, as far as both went. Where one went further, it must be
/// because its budget stopped the other. Repeats that found less than kLeastOfATrace better points tell nothing:
/// methods that find nothing are all alike. (Entries that draw random numbers have streams of their own, and are never
/// alike.)
struct Alias {
  std::string first, second;  ///< labels
  std::size_t repeats = 0;    ///< that both have
};
inline constexpr std::size_t kLeastOfATrace = 5;
/// Of trials of one problem, pairs in the order of their first trials.
[[nodiscard]] std::vector<Alias> aliases(std::span<const TrialRecord* const> trials);

/// Time per evaluation of the first repeat over the median of the others': above 1 where the first has paid for what
/// the others found made (pages, caches, clocks of a processor that idled). Empty with fewer than three repeats, and
/// for trials shorter than kShortestToldSeconds.
[[nodiscard]] std::optional<double> first_to_rest(std::span<const TrialRecord* const> trials);

}  // namespace nodal
