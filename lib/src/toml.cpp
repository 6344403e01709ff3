// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/toml.h>

#include <algorithm>

#include <toml++/toml.h>

#include <nodal/shown.h>

#include "toml_limits.h"

namespace nodal {

namespace {

Value convert(const toml::node& node, const std::string& file);

// toml++ sorts keys; the order in which they were written comes back from their positions.
Value convert_table(const toml::table& table, const std::string& file) {
  Value result;
  std::vector<std::pair<toml::source_position, Value::Table::value_type>> entries;
  for (const auto& [key, child] : table)
    entries.push_back({key.source().begin, {std::string(key.str()), convert(child, file)}});
  std::ranges::stable_sort(entries, [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [position, entry] : entries) result.table().push_back(std::move(entry));
  return result;
}

Value convert(const toml::node& node, const std::string& file) {
  const Source source{file, static_cast<int>(node.source().begin.line)};
  Value result;
  if (const auto* table = node.as_table()) {
    result = convert_table(*table, file);
  } else if (const auto* array = node.as_array()) {
    Value::List items;
    for (const toml::node& child : *array) items.push_back(convert(child, file));
    result = Value(std::move(items));
  } else if (const auto* text = node.as_string()) {
    result = Value(text->get());
  } else if (const auto* integer = node.as_integer()) {
    result = Value(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    result = Value(number->get());
  } else if (const auto* boolean = node.as_boolean()) {
    result = Value(boolean->get());
  } else {
    throw InputError(source, "dates and times mean nothing here");
  }
  result.source = source;
  return result;
}

}  // namespace

Value parse_toml(std::string_view text, const std::string& file_name) {
  constexpr std::size_t kMostOfDescription = 240;
  refuse_beyond_limits(text, file_name);
  try {
    const toml::table table = toml::parse(text, file_name);
    Value result = convert_table(table, file_name);
    result.source = {file_name, 0};
    return result;
  } catch (const toml::parse_error& error) {
    throw InputError({file_name, static_cast<int>(error.source().begin.line)},
                     "not valid TOML: " + shown(error.description(), kMostOfDescription));
  }
}

}  // namespace nodal
