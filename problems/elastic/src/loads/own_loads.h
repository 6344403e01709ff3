// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Load cases that a study describes itself: what holds, what pulls.
///
/// Units    N, Pa, m.

#include <string>
#include <vector>

#include <nodal/options.h>

#include "loads/placed_load.h"

namespace nodal::elastic {

/// A load case before its reference and its group are known. What it holds as measured is held as the reference has it.
struct OwnCase {
  PlacedLoad load;
  Source source;
  std::vector<std::string> selections = {};  ///< what each selection took, for people
  std::vector<std::string> idle = {};        ///< the selections whose forces act only where supports hold the nodes
};

/// The fields of one entry of `cases`.
[[nodiscard]] OptionSchema case_fields();

/// InputError for a name that is empty or stands twice, a case that nothing pulls or moves, a freedom held at two
/// different displacements, and selections that select nothing.
[[nodiscard]] std::vector<OwnCase> read_own_cases(const std::vector<Options>& cases, const Net& net,
                                                  const MaterialField& material);

}  // namespace nodal::elastic
