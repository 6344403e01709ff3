// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/system_json.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include <nodal/shown.h>
#include <nodal/value.h>

namespace nodal::elastic {

namespace {

using Keys = std::vector<std::string>;

// Of files whose nodes and springs are elsewhere: networkx, D3 and others.
constexpr const char* kSystemForm = "a system file is {\"nodes\": […], \"springs\": […]}";

void require_table(const Value& item, const char* what, const Keys& known) {
  if (!item.is_table())
    throw InputError(item.source, fmt::format("{} must be a table, not {}", what, item.type_name()));
  for (const auto& [key, value] : item.table())
    if (std::ranges::find(known, key) == known.end())
      throw InputError(value.source, fmt::format("unknown key '{}' in {}{}", shown(key), what, name_hint(key, known)));
}

std::optional<double> number_of(const Value& item, const char* key) {
  const Value* value = item.find(key);
  if (!value) return std::nullopt;
  if (!value->is_number())
    throw InputError(value->source, fmt::format("\"{}\" must be a number, not {}", key, value->type_name()));
  return value->number();
}

NodeEntry node_of(const Value& item) {
  static const Keys keys = {"node", "x", "y", "z", "mass"};
  require_table(item, "a node", keys);
  const std::optional<double> x = number_of(item, "x"), y = number_of(item, "y");
  if (!x || !y)
    throw InputError(item.source, "a node must be {\"x\": x, \"y\": y}, with \"node\" and \"mass\" if known");
  NodeEntry entry{item.source, std::nullopt, {*x, *y}, number_of(item, "z"), number_of(item, "mass")};
  if (const Value* id = item.find("node")) {
    if (!id->is_integer()) throw InputError(id->source, "\"node\" must be an integer");
    entry.id = id->integer();
  }
  return entry;
}

SpringEntry spring_of(const Value& item) {
  static const Keys keys = {"nodes", "stiffness", "length", "group"};
  require_table(item, "a spring", keys);
  const Value* nodes = item.find("nodes");
  const bool pair = nodes && nodes->is_list() && nodes->list().size() == 2 && nodes->list()[0].is_integer() &&
                    nodes->list()[1].is_integer();
  if (!pair) throw InputError(item.source, "a spring must be {\"nodes\": [i, j]}, with \"stiffness\" if known");
  SpringEntry entry{item.source,
                    nodes->list()[0].integer(),
                    nodes->list()[1].integer(),
                    number_of(item, "stiffness"),
                    number_of(item, "length"),
                    {}};
  if (const Value* group = item.find("group")) {
    if (!group->is_text() || group->text().empty())
      throw InputError(group->source, "\"group\" must be a text that is not empty");
    entry.group = group->text();
  }
  return entry;
}

void check_schema(const Value& file, const std::string& name) {
  const Value* schema = file.find("schema");
  if (!schema) return;
  if (!schema->is_integer() || schema->integer() < 1)
    throw InputError(schema->source, "\"schema\" must be an integer of at least 1");
  if (schema->integer() > kSystemSchema)
    throw InputError(Source{name, schema->source.line},
                     fmt::format("the file has schema {}, this build reads up to {}; use a newer nodal",
                                 schema->integer(), kSystemSchema));
}

std::optional<std::array<double, 2>> bounds_of(const Value& file) {
  const Value* bounds = file.find("bounds");
  if (!bounds) return std::nullopt;
  const bool pair =
      bounds->is_list() && bounds->list().size() == 2 && bounds->list()[0].is_number() && bounds->list()[1].is_number();
  const double lower = pair ? bounds->list()[0].number() : 0.0, upper = pair ? bounds->list()[1].number() : 0.0;
  if (!(0.0 < lower && lower < upper))
    throw InputError(bounds->source, "\"bounds\" must be [lower, upper] in N/m with 0 < lower < upper");
  return std::array<double, 2>{lower, upper};
}

// The list under a key, each entry by `read`; false where it isn't there.
template <class Entry>
bool read_list(const Value& file, const char* key, Entry (*read)(const Value&), std::vector<Entry>& entries) {
  const Value* list = file.find(key);
  if (!list) return false;
  if (!list->is_list()) throw InputError(list->source, fmt::format("\"{}\" must be a list; {}", key, kSystemForm));
  entries.reserve(list->list().size());
  for (const Value& item : list->list()) entries.push_back(read(item));
  return true;
}

}  // namespace

SystemJson parse_system_json(std::string_view text, const std::string& name) {
  static const Keys keys = {"schema", "bounds", "nodes", "springs"};
  const Value file = parse_json(text, name);
  if (!file.is_table()) throw InputError({name, 0}, kSystemForm);
  check_schema(file, name);  // first: a newer schema may have other keys
  if (!file.find("nodes") && !file.find("springs")) throw InputError({name, 0}, kSystemForm);
  require_table(file, "a system file", keys);
  SystemJson system;
  system.bounds = bounds_of(file);
  system.has_nodes = read_list(file, "nodes", node_of, system.nodes);
  system.has_springs = read_list(file, "springs", spring_of, system.springs);
  return system;
}

}  // namespace nodal::elastic
