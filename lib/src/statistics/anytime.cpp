// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/anytime.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../never.h"

namespace nodal::statistics {

namespace {

// The surface of a share is the k-th best of the histories' qualities, from 0.
std::size_t rank_of(double share, std::size_t histories) {
  if (!(share > 0.0 && share <= 1.0)) throw std::invalid_argument("statistics: a share lies in (0, 1]");
  constexpr double kRounding = 1e-9;  // 0.3 · 10 is 3 histories, not 4
  const double least = std::max(1.0, std::ceil(share * static_cast<double>(histories) - kRounding));
  return static_cast<std::size_t>(least) - 1;
}

struct Improvement {
  double cost, quality;
  std::size_t history;
};

// Of all histories, by cost.
std::vector<Improvement> improvements_of(std::span<const History> histories) {
  std::vector<Improvement> improvements;
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (const BestSoFar& point : histories[h]) improvements.push_back({point.cost, point.quality, h});
  std::ranges::stable_sort(improvements, {}, &Improvement::cost);
  return improvements;
}

}  // namespace

double quality_at(const History& history, double cost) {
  const auto later =
      std::ranges::partition_point(history, [cost](const BestSoFar& point) { return point.cost <= cost; });
  return later == history.begin() ? kNever : std::prev(later)->quality;
}

double attainment(std::span<const History> histories, double cost, double quality) {
  if (histories.empty()) return 0.0;
  const auto there =
      std::ranges::count_if(histories, [&](const History& history) { return quality_at(history, cost) <= quality; });
  return static_cast<double>(there) / static_cast<double>(histories.size());
}

History attainment_surface(std::span<const History> histories, double share) {
  return attainment_surfaces(histories, {&share, 1}).front();
}

std::vector<History> attainment_surfaces(std::span<const History> histories, std::span<const double> shares) {
  std::vector<std::size_t> ranks;
  for (const double share : shares) ranks.push_back(rank_of(share, histories.size()));
  std::vector<History> surfaces(shares.size());
  if (histories.empty()) return surfaces;
  const std::vector<Improvement> improvements = improvements_of(histories);
  std::vector<double> now(histories.size(), kNever), sorted = now;
  for (std::size_t i = 0; i < improvements.size(); ++i) {
    const auto [cost, quality, history] = improvements[i];
    sorted.erase(std::ranges::lower_bound(sorted, now[history]));
    sorted.insert(std::ranges::lower_bound(sorted, quality), quality);
    now[history] = quality;
    if (i + 1 < improvements.size() && improvements[i + 1].cost == cost) continue;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      if (const double best = sorted[ranks[s]];
          best < kNever && (surfaces[s].empty() || best < surfaces[s].back().quality))
        surfaces[s].push_back({cost, best});
  }
  return surfaces;
}

double area_over_convergence(const History& gaps, const AnytimeLimits& limits) {
  if (!(0.0 < limits.from && limits.from < limits.to && 0.0 < limits.smallest && limits.smallest < limits.largest))
    throw std::invalid_argument("statistics: limits of an area must be positive and in order");
  const double whole = std::log(limits.largest / limits.smallest);
  // The room above the curve is summed, not what is under it: without any the area is 0, not what rounding leaves.
  const auto room = [&](double gap) {
    return gap > 0.0 ? 1.0 - std::clamp(std::log(gap / limits.smallest) / whole, 0.0, 1.0) : 1.0;
  };
  double over = 0.0, from = limits.from, gap = quality_at(gaps, limits.from);
  for (const BestSoFar& point : gaps) {
    if (point.cost <= limits.from) continue;
    if (point.cost >= limits.to) break;
    over += room(gap) * std::log(point.cost / from);
    from = point.cost;
    gap = point.quality;
  }
  over += room(gap) * std::log(limits.to / from);
  return std::min(1.0, over / std::log(limits.to / limits.from));
}

}  // namespace nodal::statistics
