// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/drawing_cost.h"

#include <algorithm>

#include <fmt/format.h>

namespace nodal::elastic::show {

namespace {

// A net that can't move has at least 2n − 3 springs; of a grid that is clipped to a body most nodes may go.
constexpr double kMostNodes = kMostPicturedSprings, kMostGridNodes = 10.0 * kMostPicturedSprings;
constexpr double kMostVoronoiSteps = 1e7;  // points times iterations: some ten seconds

double grid_nodes(const Value& points) {
  double nodes = 1.0;
  if (const Value* counts = points.find("counts"); counts && counts->is_list())
    for (const Value& count : counts->list()) nodes *= count.is_number() ? count.number() : 1.0;
  return nodes;
}

}  // namespace

std::string drawing_refusal(const Value& problem) {
  const Value* points = problem.is_table() ? problem.find("points") : nullptr;
  if (!points || !points->is_table()) return {};
  const double grid = grid_nodes(*points), total = points->number_or("total", 0.0);
  const double iterations = points->number_or("iterations", 0.0);
  if (grid > kMostGridNodes || total > kMostNodes)
    return fmt::format("{:.0f} nodes are too many for a picture", std::max(grid, total));
  if (total * iterations > kMostVoronoiSteps)
    return fmt::format("{:.0f} points, iterated {:.0f} times, take too long for a picture", total, iterations);
  return {};
}

}  // namespace nodal::elastic::show
