// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The ledger of lane arithmetic in the units of CHOLMOD's: real groups only, empty lanes count for nothing.

#include <cstdint>
#include <vector>

#include <nodal/evaluator.h>

#include "displacements/lane_system.h"

namespace nodal::elastic {

/// How often something was done to every system.
struct LaneCounts {
  std::int64_t factorizations = 0;
  std::int64_t path_passes = 0;  ///< over the columns from a spring to the root
  std::int64_t full_passes = 0;  ///< over every block
  std::int64_t solves = 0;       ///< right-hand sides
  std::int64_t rank_one_updates = 0;
};

[[nodiscard]] Work lane_work(const LaneSystem& system, const LaneCounts& counts);
[[nodiscard]] Work lane_work(const std::vector<LaneSystem>& systems, const LaneCounts& counts);

}  // namespace nodal::elastic
