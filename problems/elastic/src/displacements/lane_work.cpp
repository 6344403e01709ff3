// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/lane_work.h"

namespace nodal::elastic {

Work lane_work(const LaneSystem& system, const LaneCounts& counts) {
  const NodeGraph& graph = system.structure().graph();
  const auto groups = static_cast<std::int64_t>(system.structure().groups());
  const auto d = static_cast<double>(graph.dimension);
  const double flops_per_block = 2.0 * d * d;  // as many multiplications as additions
  const double passes = static_cast<double>(counts.path_passes) * graph.path_blocks +
                        static_cast<double>(counts.full_passes) * static_cast<double>(graph.blocks());
  const double factoring = static_cast<double>(counts.factorizations) * graph.factorization_flops;
  return {.factorizations = groups * counts.factorizations,
          .solves = groups * counts.solves,
          .rank_one_updates = groups * counts.rank_one_updates,
          .flops = static_cast<double>(groups) * (factoring + flops_per_block * passes),
          .factorization_flops = static_cast<double>(groups) * factoring};
}

Work lane_work(const std::vector<LaneSystem>& systems, const LaneCounts& counts) {
  Work total;
  for (const LaneSystem& system : systems) total += lane_work(system, counts);
  return total;
}

}  // namespace nodal::elastic
