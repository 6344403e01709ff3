// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "../never.h"

namespace nodal::statistics {

namespace {

void require_order(std::span<const double> values) {
  if (std::ranges::any_of(values, [](double v) { return std::isnan(v); }))
    throw std::invalid_argument("statistics: NaN has no place in an order");
}

// Indices in the order of the values, and groups of equal ones: calls with (first, last) of `order`.
template <class Visit>
std::vector<std::size_t> visit_groups(std::span<const double> values, Visit visit) {
  require_order(values);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first + 1;
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    visit(order, first, last);
    first = last;
  }
  return order;
}

}  // namespace

double quantile_of_sorted(std::span<const double> sorted, double p) {
  if (sorted.empty() || !(p >= 0.0 && p <= 1.0))
    throw std::invalid_argument("statistics: a quantile needs a value and a share between 0 and 1");
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below);
  if (part == 0.0 || below + 1 == sorted.size()) return sorted[below];
  if (sorted[below + 1] == kNever) return kNever;
  return sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

double quantile(std::vector<double> values, double p) {
  require_order(values);
  std::ranges::sort(values);
  return quantile_of_sorted(values, p);
}

std::optional<std::pair<double, double>> median_interval(std::vector<double> values, double confidence) {
  require_order(values);
  if (!(confidence > 0.0 && confidence < 1.0))
    throw std::invalid_argument("statistics: a confidence lies between 0 and 1");
  std::ranges::sort(values);
  // P(Bin(n, ½) = k), k rising, until the tail is too heavy. By logarithms: 0.5ⁿ is 0 beyond 1,074 values.
  const auto n = static_cast<double>(values.size());
  double log_chance = n * std::log(0.5), tail = std::exp(log_chance);
  std::size_t j = 0;
  while (tail <= 0.5 * (1.0 - confidence) && 2 * j < values.size()) {
    ++j;
    log_chance += std::log((n - static_cast<double>(j) + 1.0) / static_cast<double>(j));
    tail += std::exp(log_chance);
  }
  if (j == 0) return std::nullopt;
  return std::pair(values[j - 1], values[values.size() - j]);
}

std::vector<double> mid_ranks(std::span<const double> values) {
  std::vector<double> ranks(values.size());
  visit_groups(values, [&](const std::vector<std::size_t>& order, std::size_t first, std::size_t last) {
    // The mean of first + 1, …, last.
    const double rank = 0.5 * static_cast<double>(first + 1 + last);
    for (std::size_t i = first; i < last; ++i) ranks[order[i]] = rank;
  });
  return ranks;
}

double tie_term(std::span<const double> values) {
  double sum = 0.0;
  visit_groups(values, [&](const std::vector<std::size_t>&, std::size_t first, std::size_t last) {
    const auto t = static_cast<double>(last - first);
    sum += t * t * t - t;
  });
  return sum;
}

}  // namespace nodal::statistics
