// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/settings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/shown.h>
#include <nodal/toml.h>

namespace nodal {

namespace {

struct Setting {
  Source source;
  std::string entry, label;       // "problem", "25 nodes"; the second may be empty
  std::vector<std::string> keys;  // below it
  Value value;
};

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.' || c == '/';
  });
}

Value value_of(std::string_view text, const Source& source) {
  Value value;
  try {
    value = parse_toml(fmt::format("value = {}", text), source.file).at("value");
  } catch (const InputError&) {
    if (!is_word(text))
      throw InputError(source, fmt::format("'{}' is no TOML value; texts with blanks or other signs need quotes within "
                                           "those of the shell, as --set 'study.name=\"a b\"'",
                                           shown(text)));
    value = Value(text);
  }
  value.source = source;
  return value;
}

std::vector<std::string> split(std::string_view keys) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t dot = keys.find('.');
    parts.emplace_back(keys.substr(0, dot));
    if (dot == std::string_view::npos) return parts;
    keys.remove_prefix(dot + 1);
  }
}

Setting read(const std::string& text) {
  Setting setting;
  setting.source = {fmt::format("--set {}", shown(text)), 0};
  // A label may hold dots and equals signs.
  const std::size_t open = text.find('['), first = text.find_first_of(".=");
  const bool labelled = open != std::string::npos && open < first;
  const std::size_t close = labelled ? text.find(']', open) : 0;
  const std::size_t equals = close == std::string::npos ? close : text.find('=', close);
  if (equals == std::string::npos || equals == 0)
    throw InputError(setting.source, "sets nothing; write it as problem.material.poisson=0.2");
  setting.keys = split(std::string_view(text).substr(labelled ? close + 1 : 0, equals - (labelled ? close + 1 : 0)));
  if (labelled) {
    setting.label = text.substr(open + 1, close - open - 1);
    setting.keys.front().insert(0, text.substr(0, open));
  }
  setting.entry = setting.keys.front();
  setting.keys.erase(setting.keys.begin());
  if (setting.entry.empty() || std::ranges::any_of(setting.keys, &std::string::empty))
    throw InputError(setting.source, "has an empty key; write it as problem.material.poisson=0.2");
  if (setting.keys.empty() && setting.entry != "include")
    throw InputError(setting.source,
                     fmt::format("sets a whole table; give one of its keys, as {}.KEY=VALUE", shown(setting.entry)));
  setting.value = value_of(std::string_view(text).substr(equals + 1), setting.source);
  return setting;
}

void set(Value& table, const Setting& setting) {
  Value* at = &table;
  for (std::size_t k = 0;; ++k) {
    if (!at->is_table())
      throw InputError(setting.source, fmt::format("'{}' is {} in this study, and has no keys",
                                                   k == 0 ? setting.entry : setting.keys[k - 1], at->type_name()));
    const std::string& key = setting.keys[k];
    if (k + 1 == setting.keys.size()) return at->set(key, setting.value);
    auto there = std::ranges::find(at->table(), key, &Value::Table::value_type::first);
    if (there == at->table().end()) {
      Value made;
      made.source = setting.source;
      at->table().emplace_back(key, std::move(made));
      there = std::prev(at->table().end());
    }
    at = &there->second;
  }
}

// What an entry is called before anybody looks at it.
std::string name_of(const Value& entry) {
  for (const char* key : {"label", "kind", "use"})
    if (std::string name = entry.is_table() ? entry.text_or(key, "") : ""; !name.empty()) return name;
  return {};
}

void apply(Value& root, const Setting& setting) {
  if (!root.find(setting.entry)) {
    Value made;
    made.source = setting.source;
    root.set(setting.entry, std::move(made));
  }
  Value& found = std::ranges::find(root.table(), setting.entry, &Value::Table::value_type::first)->second;
  std::vector<Value*> entries;
  if (found.is_list())
    for (Value& entry : found.list()) entries.push_back(&entry);
  else
    entries.push_back(&found);
  std::vector<std::string> names;
  bool any = false;
  for (Value* entry : entries) {
    names.push_back(name_of(*entry));
    if (!setting.label.empty() && names.back() != setting.label) continue;
    set(*entry, setting);
    any = true;
  }
  if (!any)
    throw InputError(setting.source, fmt::format("no [[{}]] of the study is labelled '{}'{}", setting.entry,
                                                 shown(setting.label), name_hint(setting.label, names)));
}

}  // namespace

void apply_settings(Value& root, const std::vector<std::string>& settings) {
  for (const std::string& text : settings) apply(root, read(text));
}

}  // namespace nodal
