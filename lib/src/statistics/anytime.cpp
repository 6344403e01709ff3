// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/anytime.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../never.h"

namespace nodal::statistics {

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
  if (!(share > 0.0 && share <= 1.0)) throw std::invalid_argument("statistics: a share lies in (0, 1]");
  if (histories.empty()) return {};
  std::vector<double> costs;
  for (const History& history : histories)
    for (const BestSoFar& point : history) costs.push_back(point.cost);
  std::ranges::sort(costs);
  costs.erase(std::unique(costs.begin(), costs.end()), costs.end());

  // The k-th best of the histories' qualities, as they fall one by one.
  constexpr double kRounding = 1e-9;  // 0.3 · 10 is 3 histories, not 4
  const double least = std::max(1.0, std::ceil(share * static_cast<double>(histories.size()) - kRounding));
  const auto k = static_cast<std::size_t>(least) - 1;
  std::vector<std::size_t> next(histories.size(), 0);
  std::vector<double> now(histories.size(), kNever), sorted;
  History surface;
  for (const double cost : costs) {
    for (std::size_t h = 0; h < histories.size(); ++h)
      for (; next[h] < histories[h].size() && histories[h][next[h]].cost <= cost; ++next[h])
        now[h] = histories[h][next[h]].quality;
    sorted = now;
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(k));
    const double quality = sorted[k];
    if (quality < kNever && (surface.empty() || quality < surface.back().quality)) surface.push_back({cost, quality});
  }
  return surface;
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
