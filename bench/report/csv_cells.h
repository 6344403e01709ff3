// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Cells of the CSV files: RFC 4180, with plain newlines.

#include <optional>
#include <string>
#include <vector>

namespace nodal::report::csv {

using Cells = std::vector<std::string>;

/// A text: harmless in a terminal and in a spreadsheet, which computes what begins like a formula, quoted or not.
[[nodiscard]] std::string quoted(const std::string& label);
/// Fewest digits that read back to the same double; empty for none and for what is not finite.
[[nodiscard]] std::string exact(std::optional<double> value);
[[nodiscard]] std::string flag(bool value);
[[nodiscard]] std::string line(const Cells& cells);

}  // namespace nodal::report::csv
