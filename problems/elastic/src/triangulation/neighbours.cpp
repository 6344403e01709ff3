// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "triangulation/triangulation.h"

namespace nodal::elastic::plane {

Neighbours::Neighbours(std::size_t nodes, const std::vector<std::array<std::size_t, 2>>& edges)
    : begin_(nodes + 1, 0), others_(2 * edges.size()) {
  for (const auto& [i, j] : edges) {
    ++begin_[i + 1];
    ++begin_[j + 1];
  }
  for (std::size_t i = 0; i < nodes; ++i) begin_[i + 1] += begin_[i];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const auto& [i, j] : edges) {
    others_[next[i]++] = j;
    others_[next[j]++] = i;
  }
  for (std::size_t i = 0; i < nodes; ++i)
    std::sort(others_.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
              others_.begin() + static_cast<std::ptrdiff_t>(begin_[i + 1]));
}

}  // namespace nodal::elastic::plane
