// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/settings.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/shown.h>
#include <nodal/toml.h>

#include "study/best_known.h"

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

// ".5", "1.", "007": words of which nobody would think that they are texts.
bool starts_like_a_number(std::string_view text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  return digit(sign) || (sign < text.size() && text[sign] == '.' && digit(sign + 1));
}

Value value_of(std::string_view text, const Source& source) {
  Value value;
  try {
    const Value parsed = parse_toml(fmt::format("value = {}", text), source.file);
    if (parsed.table().size() != 1) throw InputError(source, "sets more than one key; give each a --set of its own");
    value = parsed.at("value");
  } catch (const InputError&) {
    if (!is_word(text) || starts_like_a_number(text))
      throw InputError(source,
                       fmt::format("'{}' is no TOML value; numbers begin and end with a digit, as 0.5, and texts with "
                                   "blanks or other signs need quotes within those of the shell, as --set "
                                   "'study.name=\"a b\"'",
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
  if (setting.entry == "include")
    throw InputError(setting.source,
                     "comes too late: what is included is read before keys are set; give include in the "
                     "study, or a study of your own that includes it");
  if (setting.keys.empty())
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
std::string entry_name(const Value& entry) {
  for (const char* key : {"label", "kind", "use"})
    if (std::string name = entry.is_table() ? entry.text_or(key, "") : ""; !name.empty()) return name;
  return {};
}

// Which problems were given another value, and which another best known quality.
struct Changed {
  std::set<std::size_t> problems, best_known;
};

void apply(Value& root, const Setting& setting, Changed& changed) {
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
  for (std::size_t i = 0; i < entries.size(); ++i) {
    names.push_back(entry_name(*entries[i]));
    if (!setting.label.empty() && names.back() != setting.label) continue;
    if (setting.entry == "problem" && setting.keys.size() == 2 && setting.keys[0] == "best_known")
      replace_best_known(*entries[i], setting.keys[1]);
    set(*entries[i], setting);
    any = true;
    if (setting.entry == "problem" && setting.keys.front() != "label")
      (setting.keys.front() == "best_known" ? changed.best_known : changed.problems).insert(i);
  }
  if (!any)
    throw InputError(setting.source, fmt::format("no [[{}]] of the study is labelled '{}'{}", setting.entry,
                                                 shown(setting.label), name_hint(setting.label, names)));
}

// It was of the problem as it was.
void forget_best_known(Value& problem) {
  std::erase_if(problem.table(), [](const auto& entry) { return entry.first == "best_known"; });
}

}  // namespace

void apply_settings(Value& root, const std::vector<std::string>& settings) {
  Changed changed;
  for (const std::string& text : settings) apply(root, read(text), changed);
  const auto found = std::ranges::find(root.table(), "problem", &Value::Table::value_type::first);
  for (const std::size_t i : changed.problems)
    if (!changed.best_known.contains(i))
      forget_best_known(found->second.is_list() ? found->second.list()[i] : found->second);
}

}  // namespace nodal
