// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Tests of all pairs of a list of optimizers.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <nodal/verdict.h>

#include "observations.h"

namespace nodal::verdict {

/// What two optimizers had in one problem, in the unit of their comparison.
struct Samples {
  bool paired = false;  ///< then of equal length, each place one start
  std::vector<double> x, y;
};

/// Paired where they share two starts or more, each repeat's being one for both. `value` is what a quality counts as.
template <class Value>
[[nodiscard]] Samples samples_of(const Observations& a, const Observations& b, Value value);

struct Tested {
  PairTest test = PairTest::none;
  std::size_t pairs = 0;
  double p = 1.0;                ///< adjusted by `adjust`
  std::optional<double> effect;  ///< Â that the first is larger
};

/// Of one problem.
[[nodiscard]] Tested test_pair(const Samples& samples);
/// Of several together: Wilcoxon's test over all pairs, effects weighed by pairs; untested where one isn't paired.
[[nodiscard]] Tested test_pairs_together(std::span<const Samples> by_problem);

/// Holm over those that were tested; returns how many these are.
std::size_t adjust(std::vector<Tested>& tests);

/// Where the pair i < j of `count` stands in a list of all.
[[nodiscard]] constexpr std::size_t pair_index(std::size_t i, std::size_t j, std::size_t count) {
  return i * count - i * (i + 1) / 2 + j - i - 1;
}

template <class Value>
Samples samples_of(const Observations& a, const Observations& b, Value value) {
  Samples samples;
  std::vector<double> starts;
  bool shared = true;
  for (const Observation& one : a.all)
    for (const Observation& other : b.all)
      if (one.repeat == other.repeat) {
        shared = shared && one.start && one.start == other.start;
        if (one.start) starts.push_back(*one.start);
        samples.x.push_back(value(one.quality));
        samples.y.push_back(value(other.quality));
      }
  std::ranges::sort(starts);
  samples.paired = shared && starts.size() >= 2 && std::ranges::adjacent_find(starts) == starts.end();
  if (samples.paired) return samples;
  samples.x.clear();
  samples.y.clear();
  for (const Observation& one : a.all) samples.x.push_back(value(one.quality));
  for (const Observation& other : b.all) samples.y.push_back(value(other.quality));
  return samples;
}

}  // namespace nodal::verdict
