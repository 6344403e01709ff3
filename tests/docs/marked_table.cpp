// SPDX-License-Identifier: GPL-3.0-or-later
#include "marked_table.h"

#include <algorithm>
#include <sstream>

#include <nodal/error.h>

namespace nodal::docs {

namespace {

constexpr const char* kEnd = "<!-- end of what is made -->\n";

Range range_of(const std::string& page, const std::string& study) {
  const std::string mark = "<!-- made from " + study + " -->\n";
  const std::size_t begin = page.find(mark), end = page.find(kEnd, begin);
  if (begin == std::string::npos || end == std::string::npos)
    throw InputError("the page has no table of " + study + ": no comments say where it begins and ends");
  return {begin + mark.size(), end - begin - mark.size()};
}

std::vector<std::string> cells_of_row(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 1; at < line.size();) {
    const std::size_t bar = std::min(line.find('|', at), line.size());
    const std::size_t first = line.find_first_not_of(' ', at), last = line.find_last_not_of(' ', bar - 1);
    cells.push_back(first < bar ? line.substr(first, last + 1 - first) : "");
    at = bar + 1;
  }
  return cells;
}

}  // namespace

std::string with_marked_table(std::string page, const std::string& study, const std::string& table) {
  const Range range = range_of(page, study);
  return page.replace(range.begin, range.size, table);
}

std::vector<std::vector<std::string>> marked_rows(const std::string& page, const std::string& study) {
  const Range range = range_of(page, study);
  std::istringstream lines(page.substr(range.begin, range.size));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(cells_of_row(line));
  return rows;
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += "|";
    for (const std::string& cell : rows[r]) text += (cell.empty() ? "" : " " + cell) + " |";
    text += "\n";
    if (r > 0) continue;
    text += "|";
    for (std::size_t c = 0; c < rows[r].size(); ++c) text += "---|";
    text += "\n";
  }
  return text;
}

}  // namespace nodal::docs
