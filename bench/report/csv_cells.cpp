// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv_cells.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/shown.h>

namespace nodal::report::csv {

namespace {

// With an apostrophe it is text.
std::string harmless(const std::string& text) {
  return !text.empty() && std::string_view("=+-@").find(text[0]) != std::string_view::npos ? "'" + text : text;
}

}  // namespace

std::string quoted(const std::string& label) {
  const std::string text = harmless(printable(label));
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string exact(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : "";
}

std::string flag(bool value) { return value ? "true" : "false"; }

std::string line(const Cells& cells) { return fmt::format("{}\n", fmt::join(cells, ",")); }

}  // namespace nodal::report::csv
