// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/includes.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/options.h>
#include <nodal/shown.h>
#include <nodal/toml.h>

#include "study/best_known.h"

namespace nodal {

namespace {

namespace fs = std::filesystem;

constexpr const char* kInclude = "include";

const OptionSchema& schema() {
  static const OptionSchema one = {{.name = kInclude, .type = OptionType::text_list}};
  return one;
}

Value::List as_list(Value value) {
  if (value.is_list()) return std::move(value.list());
  Value::List list;
  list.push_back(std::move(value));
  return list;
}

// Puts `over` into `below`, key by key.
void join(Value& below, Value over) {
  for (auto& [key, value] : over.table()) {
    const auto there = std::ranges::find(below.table(), key, &Value::Table::value_type::first);
    if (there == below.table().end())
      below.table().emplace_back(key, std::move(value));
    else if (there->second.is_table() && value.is_table())
      join(there->second, std::move(value));
    else
      there->second = std::move(value);
  }
  below.source = over.source;
}

bool has_entries(const Value& value) { return value.is_list() && !value.list().empty() && value.list()[0].is_table(); }

// A best known quality is of the problem as the included file has it.
void forget_best_known(Value& below, const Value& over) {
  const auto changes = [](const auto& entry) { return entry.first != "label" && entry.first != "best_known"; };
  if (below.is_table() && over.is_table() && std::ranges::any_of(over.table(), changes))
    std::erase_if(below.table(), [](const auto& entry) { return entry.first == "best_known"; });
}

void replace_ways(Value& below, const Value& over) {
  const Value* later = over.is_table() ? over.find("best_known") : nullptr;
  if (!later || !later->is_table()) return;
  for (const auto& [key, value] : later->table()) replace_best_known(below, key);
}

// The same of whole studies, whose lists of tables are entries and add up.
Value joined(Value below, Value over) {
  for (auto& [key, value] : over.table()) {
    const auto there = std::ranges::find(below.table(), key, &Value::Table::value_type::first);
    if (there == below.table().end()) continue;
    if (key == "problem") {
      forget_best_known(there->second, value);
      replace_ways(there->second, value);
    }
    if (!has_entries(value) && !has_entries(there->second)) continue;
    const Source source = value.source;
    Value::List all = as_list(std::move(there->second));
    for (Value& entry : as_list(std::move(value))) all.push_back(std::move(entry));
    value = Value(std::move(all));
    value.source = source;
  }
  join(below, std::move(over));
  return below;
}

class Including {
 public:
  Including(const std::optional<std::vector<IncludedFile>>& stored, std::vector<IncludedFile>& included)
      : stored_(stored), included_(included) {}

  Value resolve(Value root, const fs::path& path) {
    const Value* given = root.find(kInclude);
    if (!given) return root;
    Value asked;
    asked.source = given->source;
    asked.set(kInclude, *given);
    const Options options = resolve_options(schema(), asked, "the study");
    const Value& names = options.at(kInclude);
    Value below;
    way_.push_back(fs::weakly_canonical(path));
    for (const Value& name : names.list())
      below = joined(std::move(below), read(path.parent_path() / name.text(), name));
    way_.pop_back();
    std::erase_if(root.table(), [](const auto& entry) { return entry.first == kInclude; });
    return joined(std::move(below), std::move(root));
  }

 private:
  Value read(const fs::path& path, const Value& name) {
    const fs::path there = fs::weakly_canonical(path);
    if (std::ranges::find(way_, there) != way_.end())
      throw InputError(name.source, fmt::format("'{}' includes itself", shown(path.string())));
    if (way_.size() > kMostIncludes)
      throw InputError(name.source, fmt::format("includes lie more than {} deep", kMostIncludes));
    if (included_.size() >= kMostIncludedFiles)
      throw InputError(name.source, fmt::format("'{}' is one file too many: a study includes at most {}",
                                                shown(path.string()), kMostIncludedFiles));
    std::string text = text_of(path, name);
    Value root = parse_toml(text, path.string());
    included_.push_back({path, std::move(text)});
    return resolve(std::move(root), path);
  }

  std::string text_of(const fs::path& path, const Value& name) const {
    if (stored_) {
      if (included_.size() < stored_->size()) return (*stored_)[included_.size()].text;
      throw InputError(name.source, fmt::format("'{}' is not stored", shown(path.string())));
    }
    try {
      return read_file(path, "included file");
    } catch (const InputError& error) {
      throw InputError(name.source, error.what());
    }
  }

  const std::optional<std::vector<IncludedFile>>& stored_;
  std::vector<IncludedFile>& included_;
  std::vector<fs::path> way_;  // from the study to the file being read
};

}  // namespace

Value with_includes(Value root, const fs::path& path, const std::optional<std::vector<IncludedFile>>& stored,
                    std::vector<IncludedFile>& included) {
  return Including(stored, included).resolve(std::move(root), path);
}

}  // namespace nodal
