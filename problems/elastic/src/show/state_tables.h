// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One solved load as tables for people.

#include <string>

#include <nodal/elastic/elastic_problem.h>

namespace nodal::elastic::show {

/// Displacements of nodes, forces of springs (positive where they pull) and of supports, with units; of each the first
/// 100 lines, and how many more `--json` has.
[[nodiscard]] std::string state_tables(const Net& net, const LoadState& load);

}  // namespace nodal::elastic::show
