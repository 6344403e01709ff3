// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/patterns.h"

#include <fnmatch.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

namespace nodal {

namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

void refuse_of_one(const Value& entry) {
  for (const char* key : {"label", "baseline"})
    if (const Value* given = entry.find(key))
      throw InputError(given->source,
                       fmt::format("'{}' is of one method, and use = \"{}\" means several; give that one "
                                   "an entry of its own",
                                   key, shown(entry.at("use").text())));
}

}  // namespace

bool is_pattern(std::string_view use) { return use.find_first_of("*?[") != std::string_view::npos; }

std::vector<Value> methods_meant(const Value& entry, const std::vector<const Value*>& all, const Registry& registry) {
  refuse_of_one(entry);
  const std::string& pattern = entry.at("use").text();
  std::vector<Value> meant;
  bool any = false;
  for (const OptimizerDescription& method : registry.optimizers()) {
    if (!matches(pattern, method.name)) continue;
    any = true;
    const bool own =
        std::ranges::any_of(all, [&](const Value* other) { return other->text_or("use", "") == method.name; });
    if (own) continue;
    Value use(method.name);
    use.source = entry.at("use").source;
    meant.push_back(entry);
    meant.back().set("use", std::move(use));
  }
  // What the build lacks is left out with its reason, whatever else is meant. Its names may be patterns themselves.
  for (const AbsentDescription& absent : registry.absent()) {
    if (!matches(pattern, absent.name)) continue;
    any = true;
    Value use(absent.name);
    use.source = entry.at("use").source;
    meant.push_back(entry);
    meant.back().set("use", std::move(use));
  }
  if (!any && !registry.find_absent(pattern))
    throw InputError(entry.at("use").source,
                     fmt::format("no optimizer's name is like '{}'; see nodal list optimizers", shown(pattern)));
  if (!any) meant.push_back(entry);  // left out, with its reason
  return meant;
}

}  // namespace nodal
