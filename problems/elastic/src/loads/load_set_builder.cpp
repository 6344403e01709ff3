// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/load_set_builder.h"

#include <algorithm>

namespace nodal::elastic {

void LoadSetBuilder::add(std::string name, std::vector<double> forces, std::vector<double> reference,
                         SupportGroup group) {
  add({std::move(name), 0, std::move(forces), std::move(reference)}, std::move(group));
}

void LoadSetBuilder::add(const LoadSet& set, std::size_t load) {
  add(set.loads[load], set.groups[set.loads[load].group]);
}

void LoadSetBuilder::add(LoadCase load, SupportGroup group) {
  std::ranges::sort(group.supports, {}, [&](const Support& s) { return freedoms_.at(s.node, s.axis); });
  // What was measured of a freedom that is held says nothing about springs.
  for (const Support& s : group.supports) {
    load.reference[freedoms_.at(s.node, s.axis)] = s.value;
    if (!load.uncertainty.empty()) load.uncertainty[freedoms_.at(s.node, s.axis)] = 0.0;
  }
  const auto same = std::ranges::find_if(
      set_.groups, [&](const SupportGroup& g) { return g.supports == group.supports && g.weights == group.weights; });
  load.group = static_cast<std::size_t>(same - set_.groups.begin());
  set_.loads.push_back(std::move(load));
  if (same == set_.groups.end()) set_.groups.push_back(std::move(group));
}

}  // namespace nodal::elastic
