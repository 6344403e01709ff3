// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r";
  const std::size_t begin = text.find_first_not_of(space);
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(space) - begin + 1));
}

// The rest of a quoted field, from behind its opening quote; moves `at` behind the closing one.
std::string quoted_field(const std::string& line, std::size_t& at, const Source& source) {
  std::string field;
  for (; at < line.size(); ++at) {
    if (line[at] != '"') {
      field += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      field += line[++at];
    } else {
      ++at;
      return field;
    }
  }
  throw InputError(source, "a quoted field doesn't end on its line");
}

std::vector<std::string> split(const std::string& line, char separator, const Source& source) {
  std::vector<std::string> fields;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" ", at);
    if (begin != std::string::npos && line[begin] == '"') {
      at = begin + 1;
      fields.push_back(quoted_field(line, at, source));
      at = std::min(line.find(separator, at), line.size());
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      fields.push_back(trimmed(std::string_view(line).substr(at, end - at)));
      at = end;
    }
    if (at >= line.size()) return fields;
    ++at;
  }
}

char separator_of(const std::string& header) {
  for (const char candidate : {';', '\t'})
    if (header.find(candidate) != std::string::npos) return candidate;
  return ',';
}

template <class Number>
std::optional<Number> parse(const std::string& field) {
  Number number{};
  const char* begin = field.data() + (field.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return number;
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string file, const std::vector<Column>& columns)
    : file_(std::move(file)) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // spreadsheets put it in front
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::istringstream in{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string content = trimmed(line);
    if (content.empty() || content[0] == '#') continue;
    if (header_.empty()) {
      read_header(content, number, columns);
      continue;
    }
    const Source source{file_, number};
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> fields = split(line, separator_, source);
    if (fields.size() != header_.size())
      throw InputError(source, fmt::format("{} fields, where the first line names {} columns: {}", fields.size(),
                                           header_.size(), fmt::join(header_, ", ")));
    fields_.push_back(std::move(fields));
    lines_.push_back(number);
  }
  if (header_.empty()) throw InputError({file_, 0}, "the file is empty; its first line must name the columns");
}

void CsvTable::read_header(const std::string& line, int number, const std::vector<Column>& columns) {
  const Source source{file_, number};
  separator_ = separator_of(line);
  header_ = split(line, separator_, source);
  std::vector<std::string> known;
  for (const Column& column : columns) known.push_back(column.name);
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (std::ranges::find(known, header_[i]) == known.end())
      throw InputError(source, fmt::format("unknown column '{}'{}", header_[i], name_hint(header_[i], known)));
    if (std::find(header_.begin(), header_.begin() + static_cast<std::ptrdiff_t>(i), header_[i]) !=
        header_.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError(source, fmt::format("column '{}' stands twice", header_[i]));
  }
  for (const Column& column : columns)
    if (column.required && !has(column.name))
      throw InputError(
          source, fmt::format("column '{}' is missing; possible columns: {}", column.name, fmt::join(known, ", ")));
}

bool CsvTable::has(std::string_view column) const { return std::ranges::find(header_, column) != header_.end(); }

Source CsvRow::source() const { return {table_.file_, table_.lines_[row_]}; }

const std::string& CsvRow::text(std::string_view column) const {
  static const std::string none;
  const auto found = std::ranges::find(table_.header_, column);
  if (found == table_.header_.end()) return none;
  return table_.fields_[row_][static_cast<std::size_t>(found - table_.header_.begin())];
}

std::optional<double> CsvRow::number(std::string_view column) const {
  const std::string& field = text(column);
  if (field.empty()) return std::nullopt;
  const std::optional<double> number = parse<double>(field);
  if (!number || !std::isfinite(*number))
    throw InputError(source(), fmt::format("'{}' is '{}'; it must be a finite number", column, field));
  return number;
}

std::optional<std::int64_t> CsvRow::integer(std::string_view column) const {
  const std::string& field = text(column);
  if (field.empty()) return std::nullopt;
  const std::optional<std::int64_t> number = parse<std::int64_t>(field);
  if (!number) throw InputError(source(), fmt::format("'{}' is '{}'; it must be an integer", column, field));
  return number;
}

double CsvRow::required_number(std::string_view column) const {
  const std::optional<double> value = number(column);
  if (!value) throw InputError(source(), fmt::format("'{}' is empty; it must be a number", column));
  return *value;
}

std::int64_t CsvRow::required_integer(std::string_view column) const {
  const std::optional<std::int64_t> value = integer(column);
  if (!value) throw InputError(source(), fmt::format("'{}' is empty; it must be an integer", column));
  return *value;
}

}  // namespace nodal::elastic
