// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A text as lines of fields: what CsvTable (csv.h) gives names to.
///
/// Fields are separated by commas, semicolons or tabs, whichever the first line has, or by what a line "sep=;" in front
/// of it says; they may stand in double quotes (a doubled quote within stands for one). Left out are blank lines, lines
/// of separators alone and lines that begin with #. Lines end with LF or CRLF; a byte order mark of UTF-8 is skipped.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/error.h>

namespace nodal::elastic {

struct CsvLine {
  Source source;
  std::string_view text;
  std::vector<std::string> fields;
};

class CsvLines {
 public:
  /// InputError for UTF-16, bytes that are 0, and carriage returns without a line feed. `text` must outlive this.
  CsvLines(std::string_view text, std::string file);

  /// The next one, nothing at the end. InputError for a quoted field that doesn't end, or goes on behind its quote.
  [[nodiscard]] std::optional<CsvLine> next();

 private:
  std::string_view take_line();
  bool take_separator(std::string_view line);

  std::string_view rest_;
  std::string file_;
  int number_ = 0;
  char separator_ = '\0';  // not known yet
};

}  // namespace nodal::elastic
