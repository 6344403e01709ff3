// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Tables of plain text, one row per line, under a line that names the columns.
///
/// Fields are separated by commas, semicolons or tabs, whichever the first line has; they may stand in double quotes (a
/// doubled quote within stands for one). Blank lines and lines that begin with # are left out. A point is the decimal
/// separator. Every error names file and line.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/error.h>

namespace nodal::elastic {

/// A column that a file may or must have.
struct Column {
  std::string name;
  bool required = false;
};

class CsvTable;

/// One line of a table; valid as long as the table is.
class CsvRow {
 public:
  [[nodiscard]] Source source() const;
  /// Empty where the table has no such column.
  [[nodiscard]] const std::string& text(std::string_view column) const;
  /// Nothing where the field is empty or the column isn't there; InputError for what is no finite number.
  [[nodiscard]] std::optional<double> number(std::string_view column) const;
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view column) const;
  /// The same, refused when empty.
  [[nodiscard]] double required_number(std::string_view column) const;
  [[nodiscard]] std::int64_t required_integer(std::string_view column) const;

 private:
  friend class CsvTable;
  CsvRow(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}

  const CsvTable& table_;
  std::size_t row_;
};

class CsvTable {
 public:
  /// InputError for an unknown, doubled or missing column, or a row with more or fewer fields than there are columns.
  CsvTable(std::string_view text, std::string file, const std::vector<Column>& columns);

  [[nodiscard]] std::size_t size() const noexcept { return lines_.size(); }
  [[nodiscard]] CsvRow row(std::size_t i) const { return {*this, i}; }
  [[nodiscard]] bool has(std::string_view column) const;
  [[nodiscard]] const std::string& file() const noexcept { return file_; }

 private:
  friend class CsvRow;
  void read_header(const std::string& line, int number, const std::vector<Column>& columns);

  std::string file_;
  char separator_ = ',';
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> fields_;
  std::vector<int> lines_;
};

}  // namespace nodal::elastic
