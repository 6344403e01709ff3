// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What stands below a table: what its marks mean, and what a reader should know before believing a row.

#include <string>
#include <vector>

#include "report_data.h"

namespace nodal::report {

inline constexpr int kDigits = 4;               ///< of errors and qualities
inline constexpr const char* kDisturbed = "†";  ///< behind a label: some trial had no core to itself

[[nodiscard]] std::vector<std::string> table_notes(const ProblemReport& problem);

}  // namespace nodal::report
