// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The table in docs/unseen_loads.md: fitted and unseen errors of every problem and optimizer of a comparison.

#include <string>
#include <vector>

#include <report/report_data.h>

namespace nodal::docs {

/// A cell "0.0068 / 0.21": fitted and unseen error; "–" for what isn't there.
[[nodiscard]] std::string unseen_cell(const std::optional<double>& fitted, const std::optional<double>& unseen);

/// Markdown: a row per problem, the start and every optimizer in columns.
[[nodiscard]] std::string unseen_table(const report::ReportData& data);

/// A page with its table, between two comments that say so, replaced. InputError when it has none.
[[nodiscard]] std::string with_unseen_table(std::string page, const std::string& table);

/// The table as the page has it, row by row, cell by cell.
[[nodiscard]] std::vector<std::vector<std::string>> unseen_rows(const std::string& page);

}  // namespace nodal::docs
