// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The faces of a report. Pure functions of collected data: the same data give the same text.

#include <cstddef>
#include <string>

#include "report_data.h"

namespace nodal::report {

/// For a terminal: a block per problem, then a legend. Where the table is wider than `width` columns it leaves out
/// quartiles, then factorizations, then evaluations, and says so; it never cuts a cell.
[[nodiscard]] std::string console_table(const ReportData& data, std::size_t width = 140);

/// Which to take, in a few lines for a terminal. Empty without an answer.
[[nodiscard]] std::string answer_lines(const ReportData& data);

/// Three tidy tables, a header line and then lines with every figure in full precision, empty for never and for what
/// doesn't exist. RFC 4180, with plain newlines; texts that begin like a formula (= + - @, tab, carriage return) have
/// an apostrophe in front.
///
/// A line per problem, optimizer and target gap.
[[nodiscard]] std::string summary_csv(const ReportData& data);
/// A line per problem and optimizer.
[[nodiscard]] std::string optimizers_csv(const ReportData& data);
/// A line per problem, optimizer and budget: what answers are made from. Over all problems together the problem is
/// empty.
[[nodiscard]] std::string budgets_csv(const ReportData& data);

/// Tables for a paper: the answer, and one for each problem, with the rules of the package booktabs.
[[nodiscard]] std::string latex_tables(const ReportData& data);
/// A text for LaTeX's text mode.
[[nodiscard]] std::string escape_latex(const std::string& text);

/// One self-contained page: opens from a file, without a network.
[[nodiscard]] std::string report_html(const ReportData& data);

}  // namespace nodal::report
