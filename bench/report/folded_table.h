// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A plain table that opens by its title.

#include <string>
#include <vector>

namespace nodal::report {

using TableRow = std::vector<std::string>;

/// The first cell of every row names it. Texts are escaped here.
[[nodiscard]] std::string folded_table(const std::string& title, const TableRow& head,
                                       const std::vector<TableRow>& rows);

/// "0.25".
[[nodiscard]] std::string share_text(double share);

}  // namespace nodal::report
