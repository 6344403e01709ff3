// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What evaluators and walks of one problem share: the node graph and the lane structures of all support groups.
///
/// Threads  immutable.

#include <memory>
#include <vector>

#include "displacements/elastic_model.h"
#include "displacements/lane_system.h"

namespace nodal::elastic {

struct LaneModel {
  explicit LaneModel(const ElasticModel& model);

  NodeGraph graph;
  std::vector<std::unique_ptr<LaneStructure>> structures;
};

/// A system for each of the structures, with the kernels that the scene asks for.
[[nodiscard]] std::vector<LaneSystem> make_systems(const ElasticModel& model, const LaneModel& lanes);

}  // namespace nodal::elastic
