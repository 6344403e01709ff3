// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The table in README.md: what `nodal compare bench/scenes/plate.toml` prints, without the legend.

#include <string>
#include <vector>

#include <report/report_data.h>

namespace nodal::docs {

/// The table as README has it. InputError when README has none.
[[nodiscard]] std::string table_of(const std::string& readme);

/// README with its table replaced by that of a report.
[[nodiscard]] std::string with_table(std::string readme, const report::ReportData& data);

/// Cells of a printed row: two spaces or more stand between them.
[[nodiscard]] std::vector<std::string> cells_of(const std::string& line);

}  // namespace nodal::docs
