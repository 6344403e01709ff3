// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The rules that springs' stiffnesses can start by. A rule is a constant in its own file, and a row of the list in
/// start_rules.cpp.

#include <string_view>
#include <vector>

#include <nodal/elastic/scene.h>

#include "tables/table.h"

namespace nodal::elastic {

struct StartRule {
  std::string_view name;
  std::string_view summary;  ///< as the option's help has it, with the name first
  std::string_view instead;  ///< the rule to take where this one is refused; empty where it never is
  /// Stiffnesses [springs] in N/m of a scene whose net, material, loads, weights and bounds are there. Refusal where
  /// the rule can't be followed.
  std::vector<double> (*make)(const Scene& scene);
};

// The one that is taken unasked.
extern const StartRule kPaperRule;  // paper.cpp

/// All of them, as people are told of them.
[[nodiscard]] Table<StartRule> start_rules();

}  // namespace nodal::elastic
