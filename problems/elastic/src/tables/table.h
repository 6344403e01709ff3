// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Small tables of what a study can choose by name: each entry is a constant beside what it describes, defined
/// `extern const`, and one list per kind declares and points to them. Choices of options, help texts, advice and
/// refusals are made from the list. docs/adding_a_layout.md adds an entry to each.

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nodal::elastic {

template <class Entry>
using Table = std::span<const Entry* const>;

/// The entry of that name; null where there is none.
template <class Entry>
[[nodiscard]] const Entry* find_named(Table<Entry> table, std::string_view name) {
  for (const Entry* entry : table)
    if (entry->name == name) return entry;
  return nullptr;
}

/// Which line of the table an entry of it is.
template <class Entry>
[[nodiscard]] std::size_t index_of(Table<Entry> table, const Entry& entry) {
  return static_cast<std::size_t>(std::ranges::find(table, &entry) - table.begin());
}

template <class Entry>
[[nodiscard]] std::vector<std::string> names_of(Table<Entry> table) {
  std::vector<std::string> names;
  for (const Entry* entry : table) names.emplace_back(entry->name);
  return names;
}

template <class Entry>
[[nodiscard]] std::vector<std::string> summaries_of(Table<Entry> table) {
  std::vector<std::string> summaries;
  for (const Entry* entry : table) summaries.emplace_back(entry->summary);
  return summaries;
}

}  // namespace nodal::elastic
