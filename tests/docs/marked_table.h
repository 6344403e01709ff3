// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Tables of pages that a program makes: between two comments, the first of which names the study.

#include <string>
#include <vector>

namespace nodal::docs {

/// A part of a page.
struct Range {
  std::size_t begin, size;
};

/// A page with the table of a study, "bench/scenes/unseen.toml", replaced. InputError when it has none.
[[nodiscard]] std::string with_marked_table(std::string page, const std::string& study, const std::string& table);

/// The table as the page has it, row by row, cell by cell.
[[nodiscard]] std::vector<std::vector<std::string>> marked_rows(const std::string& page, const std::string& study);

/// "bench/scenes/paper/fig08.toml" of "fig08".
[[nodiscard]] inline std::string paper_study(const std::string& name) { return "bench/scenes/paper/" + name + ".toml"; }

/// Markdown: the first row is the head.
[[nodiscard]] std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace nodal::docs
