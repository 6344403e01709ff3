// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/load_set_builder.h"

#include <algorithm>

namespace nodal::elastic {

void LoadSetBuilder::add(std::string name, std::vector<double> forces, std::vector<double> reference,
                         SupportGroup group, std::vector<double> uncertainty) {
  std::ranges::sort(group.supports, {}, [&](const Support& s) { return freedoms_.at(s.node, s.axis); });
  // What was measured of a freedom that is held says nothing about springs.
  for (const Support& s : group.supports) {
    reference[freedoms_.at(s.node, s.axis)] = s.value;
    if (!uncertainty.empty()) uncertainty[freedoms_.at(s.node, s.axis)] = 0.0;
  }
  const auto same = std::ranges::find_if(
      set_.groups, [&](const SupportGroup& g) { return g.supports == group.supports && g.weights == group.weights; });
  set_.loads.push_back({std::move(name), static_cast<std::size_t>(same - set_.groups.begin()), std::move(forces),
                        std::move(reference), std::move(uncertainty)});
  if (same == set_.groups.end()) set_.groups.push_back(std::move(group));
}

void LoadSetBuilder::add(const LoadSet& set, std::size_t load) {
  const LoadCase& one = set.loads[load];
  add(one.name, one.forces, one.reference, set.groups[one.group], one.uncertainty);
}

}  // namespace nodal::elastic
