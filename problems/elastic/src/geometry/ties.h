// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Choices among nodes by a distance. Equal distances differ by rounding, which depends on where the body stands: those
/// that agree within a tolerance are equal, and of equals the lowest index is chosen.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace nodal::elastic {

/// Those of the indices whose key is within `tolerance` of the least key, in their order. The farthest are the least by
/// a negative distance.
template <class Key>
[[nodiscard]] std::vector<std::size_t> all_least_by(const std::vector<std::size_t>& indices, double tolerance,
                                                    const Key& key) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : indices) least = std::min(least, static_cast<double>(key(i)));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : indices)
    if (key(i) <= least + tolerance) chosen.push_back(i);
  return chosen;
}

/// The lowest of them. There must be an index, and keys must be numbers.
template <class Key>
[[nodiscard]] std::size_t least_by(const std::vector<std::size_t>& indices, double tolerance, const Key& key) {
  return std::ranges::min(all_least_by(indices, tolerance, key));
}

}  // namespace nodal::elastic
