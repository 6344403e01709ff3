// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/table_options.h"

#include <fmt/format.h>

namespace nodal::elastic {

Option columns_option(std::initializer_list<const char*> columns) {
  OptionSchema fields;
  for (const char* column : columns)
    fields.push_back({.name = column,
                      .type = OptionType::text,
                      .default_text = "not read",
                      .help = fmt::format("what the file calls the column '{}'", column)});
  return {.name = "columns",
          .type = OptionType::table,
          .default_text = "as they are called here, and no others",
          .help = "of a CSV file: what it calls the columns; those that are named here are read, all others left out",
          .fields = std::move(fields)};
}

Option scale_option(const char* of) {
  return {.name = "scale",
          .default_text = "1",
          .minimum = 0.0,
          .minimum_excluded = true,
          .help = fmt::format("{} times this are metres: 0.001 for millimetres", of)};
}

TableOptions read_table_options(const Options& options) {
  TableOptions table;
  if (options.has("scale")) table.scale = options.number("scale");
  if (!options.has("columns")) return table;
  const Value& columns = options.at("columns");
  table.columns.source = columns.source;
  for (const auto& [ours, theirs] : columns.table()) table.columns.names.emplace_back(ours, theirs.text());
  if (table.columns.names.empty())
    throw InputError(columns.source, "'columns' names no column; say which to read, or leave it out");
  return table;
}

}  // namespace nodal::elastic
