// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/shown.h>

namespace nodal::elastic {

namespace {

template <class Number>
std::optional<Number> parse(std::string_view field) {
  Number number{};
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);  // from_chars takes no plus
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return number;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// "NaN", "-nan", "nan(ind)", "-nan(ind)": what C, C++, Python and MATLAB write.
bool is_nan(const std::string& field) {
  const std::string lower = lower_case(field);
  std::string_view text = lower;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text == "nan" || (text.starts_with("nan(") && text.ends_with(')'));
}

bool has_digit(std::string_view text) { return text.find_first_of("0123456789") != std::string_view::npos; }

// What may be meant by a field that is no number.
std::string number_advice(const std::string& field) {
  if (!has_digit(field)) return {};
  if (field.find(',') != std::string::npos) return "; a point is the decimal separator";
  const std::size_t behind = field.find_first_not_of("+-0123456789.");
  if (behind != std::string::npos && (field[behind] == 'D' || field[behind] == 'd'))
    return "; exponents are written with e, as in 1.0e+00";
  if (behind == std::string::npos && field.find_first_of("+-", 1) != std::string::npos)
    return "; exponents are written with e, as in 1.0e+00";
  return {};
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find_first_not_of(' ', at), text.size());
    at = std::min(text.find(' ', begin), text.size());
    if (at > begin) words.emplace_back(text.substr(begin, at - begin));
  }
  return words;
}

bool all_numbers(const std::vector<std::string>& words) {
  return std::ranges::all_of(words, [](const std::string& word) { return parse<double>(word).has_value(); });
}

std::vector<std::string> names_of(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  for (const Column& column : columns) names.push_back(column.name);
  return names;
}

// Whether a file's column is likely to be ours: "X", "x [m]", "x(mm)".
bool resembles(const std::string& theirs, const std::string& ours) {
  const std::string lower = lower_case(theirs);
  if (ours == "node" && (lower == "id" || lower == "number" || lower == "nr")) return true;
  if (!lower.starts_with(ours)) return false;
  return lower.size() == ours.size() || std::string_view(" [(/_").find(lower[ours.size()]) != std::string_view::npos;
}

// The study's words that would read this table: columns = { x = "x [m]", y = "…" }.
std::string columns_example(const std::vector<Column>& columns, const std::vector<std::string>& header) {
  std::string text;
  for (const Column& column : columns) {
    auto found = std::ranges::find_if(header, [&](const std::string& name) { return resembles(name, column.name); });
    if (found == header.end())  // misspelt: what is meant must not be left out
      found = std::ranges::find_if(header, [&](const std::string& name) {
        const std::vector<std::string> near = nearest_names(name, names_of(columns));
        return !near.empty() && near.front() == column.name;
      });
    if (found == header.end() && !column.required) continue;
    text += fmt::format("{}{} = \"{}\"", text.empty() ? "" : ", ", column.name,
                        found == header.end() ? "…" : shown(*found));
  }
  return "columns = { " + text + " }";
}

void refuse_doubled(const std::vector<std::string>& header, const Source& source) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : header)
    if (!seen.insert(name).second) throw InputError(source, fmt::format("column '{}' stands twice", shown(name)));
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string file, const std::vector<Column>& columns,
                   const ColumnNames& names)
    : file_(std::move(file)) {
  CsvLines lines(text, file_);
  std::optional<CsvLine> line = lines.next();
  if (!line) throw InputError({file_, 0}, "the file is empty; its first line must name the columns");
  read_header(*std::move(line), columns, names);
  while ((line = lines.next())) read_row(*std::move(line));
}

void CsvTable::read_header(CsvLine line, const std::vector<Column>& columns, const ColumnNames& names) {
  while (line.fields.back().empty()) line.fields.pop_back();  // CsvLines gives none that is empty altogether
  const std::string known = fmt::format("{}", fmt::join(names_of(columns), ", "));
  const bool single = line.fields.size() == 1;
  if (all_numbers(single ? words_of(line.fields[0]) : line.fields))
    throw InputError(line.source, fmt::format("the first line, '{}', has numbers; it must name the columns, of {}",
                                              shown(line.text), known));
  if (single && line.fields[0].find(' ') != std::string::npos && names.names.empty())
    throw InputError(line.source,
                     fmt::format("the first line, '{}', is one column: blanks don't separate columns, commas, "
                                 "semicolons and tabs do",
                                 shown(line.text)));
  header_ = line.fields;
  if (names.names.empty())
    take_as_called(line, columns);
  else
    take_as_named(line, columns, names);
}

void CsvTable::refuse_unknown(const std::string& column, const Source& source,
                              const std::vector<Column>& columns) const {
  const std::string hint = name_hint(column, names_of(columns));
  throw InputError(source, fmt::format("unknown column '{}'{}{}such a table is read by {}", shown(column), hint,
                                       hint.ends_with('?') ? " " : "; ", columns_example(columns, header_)));
}

void CsvTable::take_as_called(const CsvLine& header, const std::vector<Column>& columns) {
  const std::vector<std::string> known = names_of(columns);
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (header_[i].empty()) throw InputError(header.source, fmt::format("column {} has no name", i + 1));
    if (std::ranges::find(known, header_[i]) == known.end()) refuse_unknown(header_[i], header.source, columns);
    taken_.push_back({header_[i], i});
  }
  refuse_doubled(header_, header.source);
  for (const Column& column : columns)
    if (column.required && !has(column.name))
      throw InputError(header.source, fmt::format("column '{}' is missing; possible columns: {}", column.name,
                                                  fmt::join(known, ", ")));
}

void CsvTable::take_as_named(const CsvLine& header, const std::vector<Column>& columns, const ColumnNames& names) {
  for (const auto& [ours, theirs] : names.names) {
    const auto count = std::ranges::count(header_, theirs);
    if (count == 0)
      throw InputError(names.source, fmt::format("'columns' calls '{}' '{}', and {} has no such column{}", ours,
                                                 shown(theirs), header.source.text(), name_hint(theirs, header_)));
    if (count > 1) throw InputError(header.source, fmt::format("column '{}' stands twice", shown(theirs)));
    const auto field = static_cast<std::size_t>(std::ranges::find(header_, theirs) - header_.begin());
    const auto same = std::ranges::find(taken_, field, &Taken::field);
    if (same != taken_.end())
      throw InputError(names.source,
                       fmt::format("'columns' takes '{}' for both '{}' and '{}'", shown(theirs), same->name, ours));
    taken_.push_back({ours, field});
  }
  for (const Column& column : columns)
    if (column.required && !has(column.name))
      throw InputError(names.source,
                       fmt::format("'columns' must name '{}', too: with it, only what it names is read", column.name));
}

void CsvTable::read_row(CsvLine line) {
  std::vector<std::string>& fields = line.fields;
  while (fields.size() > header_.size() && fields.back().empty()) fields.pop_back();
  if (fields.size() != header_.size())
    throw InputError(line.source, fmt::format("{} fields, where the first line names {} columns: {}", fields.size(),
                                              header_.size(), shown(fmt::format("{}", fmt::join(header_, ", ")))));
  const bool units = lines_.empty() && std::ranges::none_of(fields, has_digit) &&
                     std::ranges::none_of(fields, is_nan) && fields.size() > 1;
  if (units)
    throw InputError(line.source, fmt::format("'{}' has no numbers: of lines above the rows there may be one, which "
                                              "names the columns; put # in front of others",
                                              shown(line.text)));
  std::vector<std::string> taken;
  for (const Taken& column : taken_) taken.push_back(std::move(fields[column.field]));
  fields_.push_back(std::move(taken));
  lines_.push_back(line.source.line);
}

std::optional<std::size_t> CsvTable::position(std::string_view column) const {
  const auto found = std::ranges::find(taken_, column, &Taken::name);
  if (found == taken_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - taken_.begin());
}

std::string CsvTable::left_out() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < header_.size(); ++i)
    if (std::ranges::find(taken_, i, &Taken::field) == taken_.end()) names.push_back(header_[i]);
  if (names.empty()) return {};
  constexpr std::size_t kMostOfNames = 200;
  return fmt::format("{}: column{} {} {} left out", std::filesystem::path(file_).filename().string(),
                     names.size() == 1 ? "" : "s", shown(fmt::format("{}", fmt::join(names, ", ")), kMostOfNames),
                     names.size() == 1 ? "is" : "are");
}

Source CsvRow::source() const { return {table_.file_, table_.lines_[row_]}; }

const std::string& CsvRow::text(std::string_view column) const {
  static const std::string none;
  const std::optional<std::size_t> position = table_.position(column);
  return position ? table_.fields_[row_][*position] : none;
}

std::optional<double> CsvRow::number(std::string_view column) const {
  const std::string& field = text(column);
  if (field.empty()) return std::nullopt;
  const std::optional<double> number = parse<double>(field);
  if (!number || !std::isfinite(*number))
    throw InputError(source(), fmt::format("'{}' is '{}'; it must be a finite number{}", column, shown(field),
                                           number_advice(field)));
  return number;
}

std::optional<double> CsvRow::measured(std::string_view column) const {
  const std::string& field = text(column);
  if (field.empty() || is_nan(field)) return std::nullopt;
  if (!has_digit(field))
    throw InputError(source(),
                     fmt::format("'{}' is '{}'; it must be a finite number, or empty or NaN where nothing was "
                                 "measured",
                                 column, shown(field)));
  return number(column);
}

std::optional<std::int64_t> CsvRow::integer(std::string_view column) const {
  const std::string& field = text(column);
  if (field.empty()) return std::nullopt;
  if (const std::optional<std::int64_t> number = parse<std::int64_t>(field)) return number;
  constexpr double kExact = 9007199254740992.0;  // 2^53: a double beyond it may be another integer
  const std::optional<double> number = parse<double>(field);
  if (!number || !(std::abs(*number) <= kExact) || *number != std::trunc(*number))
    throw InputError(source(), fmt::format("'{}' is '{}'; it must be an integer", column, shown(field)));
  return static_cast<std::int64_t>(*number);
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
