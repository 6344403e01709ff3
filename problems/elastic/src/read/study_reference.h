// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacements that a study's loads are compared with.

#include <string>
#include <vector>

#include <nodal/elastic/scene.h>

#include "loads/placed_load.h"
#include "reference/references.h"

namespace nodal::elastic {

/// The fields of `reference`.
[[nodiscard]] OptionSchema reference_fields();

/// InputError for keys that contradict each other.
[[nodiscard]] ReferenceChoice read_reference_choice(const Options& reference, std::size_t dimension);

struct MeasuredLoads {
  LoadSet loads;
  std::string summary;  ///< of what was read, for people
};

/// Loads with what a file says was measured of them. `sources`: where each load is described. InputError for what
/// doesn't fit.
[[nodiscard]] MeasuredLoads measured_loads(const Options& reference, const ProblemContext& context,
                                           std::vector<PlacedLoad> loads, const std::vector<Source>& sources,
                                           const Net& net, Account& account);

/// Loads that nobody knows a reference of: they can be solved, but nothing fitted. Together are those that would be if
/// all were known. InputError for one that is held as measured.
[[nodiscard]] LoadSet only_solved(std::vector<PlacedLoad> loads, const std::vector<Source>& sources, const Net& net);

}  // namespace nodal::elastic
