// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a study says of a table of its own: what the columns are called, and in which unit lengths are.

#include <initializer_list>

#include <nodal/options.h>

#include "import/csv.h"

namespace nodal::elastic {

struct TableOptions {
  ColumnNames columns = {};
  double scale = 1.0;  ///< metres are the file's lengths times this
};

/// The option `columns`, for a file with these.
[[nodiscard]] Option columns_option(std::initializer_list<const char*> columns);

/// The option `scale`; `of` is what it multiplies, with "of" in front: "of a file: its coordinates".
[[nodiscard]] Option scale_option(const char* of);

/// Of a table of options that has `columns`, `scale`, both or neither. InputError for `columns` without any.
[[nodiscard]] TableOptions read_table_options(const Options& options);

}  // namespace nodal::elastic
