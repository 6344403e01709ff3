// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/voronoi_account.h"

#include <cstdint>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

Value line_of(const plane::VoronoiStep& step) {
  Value line;
  line.set("iteration", Value(static_cast<std::int64_t>(step.iteration)));
  line.set("distance_deviation", step.distance_deviation);
  line.set("area_deviation", step.area_deviation);
  line.set("energy", step.energy);
  line.set("inner_energy", step.inner_energy);
  line.set("area_error", step.area_error);
  line.set("largest_move", step.largest_move);
  return line;
}

}  // namespace

void tell_of_iterations(const std::vector<plane::VoronoiStep>& history, Account& account) {
  const plane::VoronoiStep &first = history.front(), &last = history.back();
  account.used(kVoronoiStage,
               fmt::format("{} iterations: deviation of neighbours' distances {:.3g} → {:.3g}, of areas {:.3g} → "
                           "{:.3g}, energy {:.4g} → {:.4g} (hexagons: {:.4f})",
                           last.iteration, first.distance_deviation, last.distance_deviation, first.area_deviation,
                           last.area_deviation, first.energy, last.energy, plane::kHexagonalEnergy));
  Value::List lines;
  for (const plane::VoronoiStep& step : history) lines.push_back(line_of(step));
  account.data.set("voronoi", Value(std::move(lines)));
}

}  // namespace nodal::elastic
