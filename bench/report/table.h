// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The table of one problem as text cells: one source for console and page, so that they can't disagree.
///
/// Rows stand best first: by error as it is printed, equal ones by time to the default gap. (Digits beyond those
/// printed are rounding noise among methods that reach the same optimum.)

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report_data.h"

namespace nodal::report {

struct Column {
  std::string title;      ///< first line of the heading
  std::string subtitle;   ///< second line
  std::string help;       ///< one sentence for a tooltip
  bool left = false;      ///< aligned
  int rank = 0;           ///< 0 is always shown; the highest goes first where a terminal is too narrow
  std::string name = {};  ///< what to call it when it is left out
  bool compared = false;  ///< smaller is better, and how much so can be said of two rows
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::vector<std::optional<double>>> values;  ///< what rows say as numbers: to sort them, and to compare
  std::vector<std::string> optimizers;                     ///< of the rows: labels without additions
  std::vector<std::string> notes;                          ///< to stand below it: what marks mean
};

[[nodiscard]] Table make_text_table(const ProblemReport& problem);

/// "G at the start 2.302 (relative error 0.2563); G* = 0.7376 (multi-start Gauss-Newton)", provisional or not.
[[nodiscard]] std::string describe_reference(const ProblemReport& problem);

/// For the reader of these tables: what the words mean, one sentence each.
[[nodiscard]] std::vector<std::string> table_legend(std::span<const ProblemReport> problems);

}  // namespace nodal::report
