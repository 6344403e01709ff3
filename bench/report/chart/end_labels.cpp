// SPDX-License-Identifier: GPL-3.0-or-later
#include "end_labels.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace nodal::report {

namespace {

// Labels that touch. Less their own place in the stack, all of it lies at one height: the mean of what its labels want.
struct Stack {
  double sum = 0.0;
  std::size_t size = 0;
  [[nodiscard]] double mean() const { return sum / static_cast<double>(size); }
};

}  // namespace

std::vector<double> place_labels(const std::vector<double>& wanted, double spacing, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });

  std::vector<Stack> stacks;  // isotonic regression by pooling neighbours
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    stacks.push_back({wanted[order[rank]] - static_cast<double>(rank) * spacing, 1});
    while (stacks.size() > 1 && stacks[stacks.size() - 2].mean() >= stacks.back().mean()) {
      const Stack top = stacks.back();
      stacks.pop_back();
      stacks.back() = {stacks.back().sum + top.sum, stacks.back().size + top.size};
    }
  }
  // Bounds in the same coordinates: the last label ends (n − 1) spacings below the first.
  const double most = std::max(low, high - spacing * static_cast<double>(std::max<std::size_t>(wanted.size(), 1) - 1));
  std::vector<double> places(wanted.size());
  std::size_t rank = 0;
  for (const Stack& stack : stacks)
    for (std::size_t i = 0; i < stack.size; ++i, ++rank)
      places[order[rank]] = std::clamp(stack.mean(), low, most) + static_cast<double>(rank) * spacing;
  return places;
}

}  // namespace nodal::report
