// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/lane_work.h"

namespace nodal::elastic {

Work lane_work(const std::vector<LaneSystem>& systems, const LaneCounts& counts) {
  constexpr double kFlopsPerBlock = 8.0;  // four multiplications, four additions
  Work work;
  for (const LaneSystem& system : systems) {
    const NodeGraph& graph = system.structure().graph();
    const auto groups = static_cast<std::int64_t>(system.structure().groups());
    const double passes = static_cast<double>(counts.path_passes) * graph.path_blocks +
                          static_cast<double>(counts.full_passes) * static_cast<double>(graph.blocks());
    const double factoring = static_cast<double>(counts.factorizations) * graph.factorization_flops;
    work.factorizations += groups * counts.factorizations;
    work.solves += groups * counts.solves;
    work.rank_one_updates += groups * counts.rank_one_updates;
    work.factorization_flops += static_cast<double>(groups) * factoring;
    work.flops += static_cast<double>(groups) * (factoring + kFlopsPerBlock * passes);
  }
  return work;
}

}  // namespace nodal::elastic
