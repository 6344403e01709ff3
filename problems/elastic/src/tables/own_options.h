// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Options that entries of a table bring to the study's table which chooses among them: those of their own, which stand
/// beside what reads them, and by name in `keys` those of others that they read, too.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/options.h>

#include "tables/table.h"

namespace nodal::elastic {

template <class Entry>
[[nodiscard]] OptionSchema own_options(const Entry& entry) {
  return entry.options ? entry.options() : OptionSchema();
}

template <class Entry>
[[nodiscard]] bool reads(const Entry& entry, std::string_view key) {
  return std::ranges::count(entry.keys, key) > 0 || std::ranges::count(own_options(entry), key, &Option::name) > 0;
}

/// The entries that read an option, by name.
template <class Entry>
[[nodiscard]] std::vector<std::string_view> readers_of(Table<Entry> table, std::string_view key) {
  std::vector<std::string_view> readers;
  for (const Entry* entry : table)
    if (reads(*entry, key)) readers.push_back(entry->name);
  return readers;
}

/// The options of all, each with who reads it in front of its help.
template <class Entry>
[[nodiscard]] OptionSchema options_of(Table<Entry> table) {
  OptionSchema all;
  for (const Entry* entry : table)
    for (Option& option : own_options(*entry)) {
      option.help = fmt::format("{}: {}", fmt::join(readers_of(table, option.name), ", "), option.help);
      all.push_back(std::move(option));
    }
  return all;
}

/// InputError where a study says what the entry it chose doesn't read; `kind` is what entries are called: "layout".
template <class Entry>
void refuse_foreign_options(const Options& study, Table<Entry> table, const Entry& chosen, const char* kind) {
  for (const Option& option : options_of(table))
    if (study.given(option.name) && !reads(chosen, option.name))
      throw InputError(study.at(option.name).source,
                       fmt::format("'{}' belongs to {} '{}', and this one is '{}'", option.name, kind,
                                   fmt::join(readers_of(table, option.name), "' or '"), chosen.name));
}

}  // namespace nodal::elastic
