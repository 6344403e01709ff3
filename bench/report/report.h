// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The three faces of a report. Pure functions of collected data: the same data give the same text.

#include <cstddef>
#include <string>

#include "report_data.h"

namespace nodal::report {

/// For a terminal: a block per problem, then a legend. Where the table is wider than `width` columns it leaves out
/// quartiles, then factorizations, then evaluations, and says so; it never cuts a cell.
[[nodiscard]] std::string console_table(const ReportData& data, std::size_t width = 140);

/// One header line, then a line per problem and optimizer: every figure in full precision, empty for never and for what
/// doesn't exist. RFC 4180, with plain newlines; texts that begin like a formula (= + - @, tab, carriage return) have
/// an apostrophe in front.
[[nodiscard]] std::string summary_csv(const ReportData& data);

/// One self-contained page: opens from a file, without a network.
[[nodiscard]] std::string report_html(const ReportData& data);

}  // namespace nodal::report
