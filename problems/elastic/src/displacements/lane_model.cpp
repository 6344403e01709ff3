// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/lane_model.h"

#include <algorithm>
#include <span>

namespace nodal::elastic {

LaneModel::LaneModel(const ElasticModel& model) : graph(model.scene.net) {
  constexpr std::size_t kMostLanes = 8;
  const std::span groups(model.groups);
  for (std::size_t first = 0; first < groups.size(); first += kMostLanes)
    structures.push_back(std::make_unique<LaneStructure>(
        groups.subspan(first, std::min(kMostLanes, groups.size() - first)), graph, first));
}

std::vector<LaneSystem> make_systems(const ElasticModel& model, const LaneModel& lanes) {
  std::vector<LaneSystem> systems;
  for (const auto& structure : lanes.structures)
    systems.emplace_back(*structure,
                         lane_kernels(model.scene.moves.instructions, structure->dimension(), structure->lanes()));
  return systems;
}

}  // namespace nodal::elastic
