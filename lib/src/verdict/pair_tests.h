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

/// Paired where they share two starts or more, each repeat's being one for both. `value` is what counts of them.
[[nodiscard]] Samples samples_of(const Observations& a, const Observations& b, double Observation::*value);

struct Tested {
  PairTest test = PairTest::none;
  std::size_t pairs = 0;
  double p = 1.0;                ///< adjusted by `adjust`
  std::optional<double> effect;  ///< Â that the first is larger
  double lean = 0.0;             ///< above 0 where the test finds the first larger, below where the second
  [[nodiscard]] bool tells() const noexcept { return test != PairTest::none && p < kSignificance && lean != 0.0; }
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

}  // namespace nodal::verdict
