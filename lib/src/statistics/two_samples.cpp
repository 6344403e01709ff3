// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/two_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>

#include <nodal/statistics/order.h>

namespace nodal::statistics {

namespace {

// P(|Z| ≥ z).
double two_sided(double z) {
  return std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z)));
}

std::vector<double> joined(std::span<const double> x, std::span<const double> y) {
  std::vector<double> all(x.begin(), x.end());
  all.insert(all.end(), y.begin(), y.end());
  return all;
}

// U of x: its rank sum less what it has among its own.
double pairs_above(std::span<const double> x, std::span<const double> all) {
  const std::vector<double> ranks = mid_ranks(all);
  const auto n = static_cast<double>(x.size());
  return std::accumulate(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(x.size()), 0.0) -
         0.5 * n * (n + 1.0);
}

// P(W ≤ w) where each of the ranks 1 … n counts with probability ½: subsets are counted by their sums.
double exact_tail(std::size_t n, double w) {
  std::vector<double> subsets(n * (n + 1) / 2 + 1, 0.0);
  subsets[0] = 1.0;
  for (std::size_t rank = 1; rank <= n; ++rank)
    for (std::size_t sum = subsets.size() - 1; sum >= rank; --sum) subsets[sum] += subsets[sum - rank];
  const auto last = static_cast<std::ptrdiff_t>(w) + 1;
  return std::accumulate(subsets.begin(), subsets.begin() + last, 0.0) * std::pow(0.5, static_cast<double>(n));
}

}  // namespace

std::optional<double> vargha_delaney(std::span<const double> x, std::span<const double> y) {
  if (x.empty() || y.empty()) return std::nullopt;
  return pairs_above(x, joined(x, y)) / (static_cast<double>(x.size()) * static_cast<double>(y.size()));
}

std::optional<RankTest> mann_whitney(std::span<const double> x, std::span<const double> y) {
  if (x.empty() || y.empty()) return std::nullopt;
  const std::vector<double> all = joined(x, y);
  const double u = pairs_above(x, all);
  const auto n = static_cast<double>(all.size());
  const double pairs = static_cast<double>(x.size()) * static_cast<double>(y.size());
  const double variance = pairs * (n + 1.0 - tie_term(all) / (n * (n - 1.0))) / 12.0;
  if (!(variance > 0.0)) return RankTest{u, 1.0};
  return RankTest{u, two_sided((std::abs(u - 0.5 * pairs) - 0.5) / std::sqrt(variance))};
}

std::optional<RankTest> wilcoxon(std::span<const double> x, std::span<const double> y, Exactness exactness) {
  if (x.size() != y.size()) throw std::invalid_argument("statistics::wilcoxon: pairs are needed");
  if (x.empty()) return std::nullopt;
  std::vector<double> sizes;
  std::vector<bool> positive;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == y[i]) continue;
    sizes.push_back(std::abs(x[i] - y[i]));
    positive.push_back(x[i] > y[i]);
  }
  if (sizes.empty()) return RankTest{0.0, 1.0};
  const std::vector<double> ranks = mid_ranks(sizes);
  const auto n = static_cast<double>(sizes.size());
  double above = 0.0;
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (positive[i]) above += ranks[i];
  const double w = std::min(above, 0.5 * n * (n + 1.0) - above);
  const double ties = tie_term(sizes);
  if (exactness == Exactness::where_possible && ties == 0.0 && sizes.size() <= kMostExactPairs)
    return RankTest{w, std::min(1.0, 2.0 * exact_tail(sizes.size(), w))};
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
  return RankTest{w, two_sided((0.25 * n * (n + 1.0) - w) / std::sqrt(variance))};
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> adjusted(p.size());
  double most = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    most = std::max(most, static_cast<double>(order.size() - i) * p[order[i]]);
    adjusted[order[i]] = std::min(1.0, most);
  }
  return adjusted;
}

}  // namespace nodal::statistics
