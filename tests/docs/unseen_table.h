// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The table in docs/unseen_loads.md: fitted and unseen errors of every problem and optimizer of a comparison.

#include <optional>
#include <string>

#include <report/report_data.h>

namespace nodal::docs {

inline constexpr const char* kUnseenStudy = "bench/scenes/unseen.toml";

/// A cell "0.0068 / 0.21": fitted and unseen error; "–" for what isn't there.
[[nodiscard]] std::string unseen_cell(const std::optional<double>& fitted, const std::optional<double>& unseen);

/// Markdown: a row per problem, the start and every optimizer in columns.
[[nodiscard]] std::string unseen_table(const report::ReportData& data);

}  // namespace nodal::docs
