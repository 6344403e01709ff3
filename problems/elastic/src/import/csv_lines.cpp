// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/csv_lines.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/shown.h>

namespace nodal::elastic {

namespace {

constexpr std::string_view kSeparators = ",;\t";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

// The rest of a quoted field, from behind its opening quote; moves `at` behind the closing one.
std::string quoted_field(std::string_view line, std::size_t& at, const Source& source) {
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

std::vector<std::string> split(std::string_view line, char separator, const Source& source) {
  std::vector<std::string> fields;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = line.find_first_not_of(' ', at);
    if (begin != std::string_view::npos && line[begin] == '"') {
      at = begin + 1;
      fields.push_back(quoted_field(line, at, source));
      const std::size_t end = std::min(line.find(separator, at), line.size());
      if (const std::string_view behind = trimmed(line.substr(at, end - at)); !behind.empty())
        throw InputError(source,
                         fmt::format("'{}' follows the closing quote of '{}'; a quoted field ends with its quote",
                                     shown(behind), shown(fields.back())));
      at = end;
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      fields.emplace_back(trimmed(line.substr(at, end - at)));
      at = end;
    }
    if (at >= line.size()) return fields;
    ++at;
  }
}

char separator_of(std::string_view header) {
  for (const char candidate : {';', '\t'})
    if (header.find(candidate) != std::string_view::npos) return candidate;
  return ',';
}

void refuse_encoding(std::string_view text, const std::string& file) {
  const bool marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (marked || text.find('\0') != std::string_view::npos)
    throw InputError({file, 0}, marked
                                    ? "the file is in UTF-16; save it as UTF-8"
                                    : "the file has bytes that are 0: it is in UTF-16, or no text; save it as UTF-8");
  for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1))
    if (at + 1 < text.size() && text[at + 1] != '\n') {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      throw InputError({file, static_cast<int>(line)},
                       "a carriage return without a line feed, as lines of an old Mac end; save the file with line "
                       "ends LF or CRLF");
    }
}

}  // namespace

CsvLines::CsvLines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets put it in front
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  refuse_encoding(rest_, file_);
}

std::string_view CsvLines::take_line() {
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++number_;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

// "sep=;", as spreadsheets write it; true where this is such a line.
bool CsvLines::take_separator(std::string_view line) {
  constexpr std::string_view kSays = "sep=";
  if (separator_ != '\0' || !line.starts_with(kSays)) return false;
  const std::string_view given = line.substr(kSays.size());
  if (given.size() != 1 || kSeparators.find(given[0]) == std::string_view::npos)
    throw InputError({file_, number_},
                     fmt::format("the separator is '{}'; it may be a comma, a semicolon or a tab", shown(given)));
  separator_ = given[0];
  return true;
}

std::optional<CsvLine> CsvLines::next() {
  while (!rest_.empty()) {
    const std::string_view line = take_line(), content = trimmed(line);
    if (content.empty() || content[0] == '#' || take_separator(line)) continue;
    if (separator_ == '\0') separator_ = separator_of(content);
    const Source source{file_, number_};
    // A tab at an end may be a separator with nothing beside it.
    std::vector<std::string> fields = split(separator_ == '\t' ? line : content, separator_, source);
    if (std::ranges::all_of(fields, &std::string::empty)) continue;
    return CsvLine{source, content, std::move(fields)};
  }
  return std::nullopt;
}

}  // namespace nodal::elastic
