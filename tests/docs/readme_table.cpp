// SPDX-License-Identifier: GPL-3.0-or-later
#include "readme_table.h"

#include <nodal/error.h>

#include <report/report.h>
#include <report/table.h>

#include "marked_table.h"

namespace nodal::docs {

namespace {

constexpr std::size_t kWidth = 160;  // as where stdout is no terminal
constexpr const char* kBegin = "```\nelastic: G at the start ";
constexpr const char* kClosingFence = "\n```\n";

Range range_of(const std::string& readme) {
  const std::size_t fence = readme.find(kBegin);
  if (fence == std::string::npos)
    throw InputError("README has no table: no block begins with 'elastic: G at the start'");
  const std::size_t begin = fence + 4;
  return {begin, readme.find(kClosingFence, begin) - begin};
}

}  // namespace

std::string table_of(const std::string& readme) {
  const Range range = range_of(readme);
  return readme.substr(range.begin, range.size);
}

std::string with_table(std::string readme, const report::ReportData& data) {
  std::string table = report::console_table(data, kWidth);
  const std::vector<std::string> notes = report::make_text_table(data.problems.front()).notes;
  table.erase(table.find(notes.empty() ? report::table_legend(data.problems).front() : notes.front()));
  table.erase(table.find_last_not_of('\n') + 1);
  const Range range = range_of(readme);
  return readme.replace(range.begin, range.size, table);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
    const std::size_t end = line.find("  ", at);
    cells.push_back(line.substr(at, end - at));
    at = end == std::string::npos ? end : line.find_first_not_of(' ', end);
  }
  return cells;
}

}  // namespace nodal::docs
