// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One problem under a limit: who took part, how good and how soon each was, every pair tested; and the verdict on it.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include <nodal/verdict.h>

#include "../never.h"
#include "observations.h"
#include "pair_tests.h"

namespace nodal::verdict {

/// An optimizer on one problem.
struct Entrant {
  std::string label;
  Observations observed;
  double median = kNever;  ///< as it is told
  double gap = kNever;     ///< of that
  double cost = kNever;    ///< median until a quality equal to the least median
};

/// One problem under a limit.
struct Field {
  Told told;
  std::vector<Entrant> entrants;  ///< in the order asked for
  std::vector<Tested> tests;      ///< of all pairs, not adjusted
  bool improved = false;

  [[nodiscard]] double least() const {
    double least = kNever;
    for (const Entrant& entrant : entrants) least = std::min(least, entrant.median);
    return least;
  }
};

[[nodiscard]] Field field_of(const Contest& contest, const Limit& limit);
[[nodiscard]] Verdict verdict_of(const Contest& contest, const Field& field, const Limit& limit);

/// The same with the two exchanged.
[[nodiscard]] Tested turned(Tested tested);
/// Of all pairs of `count`: of `other` against `first`, with Â and lean that the other is worse.
[[nodiscard]] Tested against(const std::vector<Tested>& tests, std::size_t first, std::size_t other, std::size_t count);
[[nodiscard]] Relation relation_of(const Tested& tested, bool equal);
void set_test(const Tested& tested, Standing& standing);
/// Less than twice the first one's gap.
[[nodiscard]] bool below_twofold(double first_gap, double gap);

/// Indices, least key first.
template <class Key>
[[nodiscard]] std::vector<std::size_t> order_by(std::size_t count, Key key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, key);
  return order;
}

}  // namespace nodal::verdict
