// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Load cases that a study describes itself: what holds, what pulls.
///
/// Units    N, Pa, m.

#include <string>
#include <vector>

#include <nodal/elastic/loads.h>
#include <nodal/options.h>

namespace nodal::elastic {

/// A load case before its reference and its group are known.
struct OwnCase {
  std::string name;
  std::vector<double> forces;                 ///< [2 · nodes]
  std::vector<Support> supports;              ///< ascending freedoms, each once
  std::vector<std::size_t> held_as_measured;  ///< freedoms among them whose value is to come from the reference
  Source source;
  std::vector<std::string> selections = {};  ///< what each selection took, for people
  std::vector<std::string> idle = {};        ///< the selections whose forces act only where supports hold the nodes
};

/// The fields of one entry of `cases`.
[[nodiscard]] OptionSchema case_fields();

/// InputError for a name that is empty or stands twice, a case that nothing pulls or moves, a freedom held at two
/// different displacements, and selections that select nothing.
[[nodiscard]] std::vector<OwnCase> read_own_cases(const std::vector<Options>& cases, const Net& net);

}  // namespace nodal::elastic
