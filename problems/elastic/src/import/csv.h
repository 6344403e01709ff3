// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Tables of plain text, one row per line (csv_lines.h), under a line that names the columns.
///
/// A point is the decimal separator. Columns without a name at the end are skipped when their fields are empty, as
/// trailing separators make them. Every error names file and line.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nodal/error.h>

#include "import/csv_lines.h"

namespace nodal::elastic {

/// A column that a file may or must have.
struct Column {
  std::string name;
  bool required = false;
};

/// What a file calls the columns, where a study says it: those that are named are read, all others are left out.
struct ColumnNames {
  std::vector<std::pair<std::string, std::string>> names;  ///< ours, the file's; empty: as we call them, and no others
  Source source;                                           ///< of the study's words
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
  /// The same, and nothing where the field is NaN, in any of the ways that programs write it.
  [[nodiscard]] std::optional<double> measured(std::string_view column) const;
  /// 1.0 is an integer, too.
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
  /// InputError for an unknown, doubled or missing column, a row with more or fewer fields than there are columns, or a
  /// first line that names none.
  CsvTable(std::string_view text, std::string file, const std::vector<Column>& columns, const ColumnNames& names = {});

  [[nodiscard]] std::size_t size() const noexcept { return lines_.size(); }
  [[nodiscard]] CsvRow row(std::size_t i) const { return {*this, i}; }
  [[nodiscard]] bool has(std::string_view column) const { return position(column).has_value(); }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  /// The file's columns that ColumnNames leaves out, as a remark: "points.csv: columns a, b are left out"; empty when
  /// all are read.
  [[nodiscard]] std::string left_out() const;

 private:
  friend class CsvRow;
  void read_header(CsvLine line, const std::vector<Column>& columns, const ColumnNames& names);
  [[noreturn]] void refuse_unknown(const std::string& column, const Source& source,
                                   const std::vector<Column>& columns) const;
  void take_as_called(const CsvLine& header, const std::vector<Column>& columns);
  void take_as_named(const CsvLine& header, const std::vector<Column>& columns, const ColumnNames& names);
  void read_row(CsvLine line);
  [[nodiscard]] std::optional<std::size_t> position(std::string_view column) const;

  // A column that is read: our name for it, and where it stands in the file.
  struct Taken {
    std::string name;
    std::size_t field;
  };

  std::string file_;
  std::vector<std::string> header_;
  std::vector<Taken> taken_;
  std::vector<std::vector<std::string>> fields_;  // [rows][taken columns]
  std::vector<int> lines_;                        // [rows]
};

}  // namespace nodal::elastic
