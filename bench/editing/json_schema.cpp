// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_schema.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/study.h>

#include "option_json.h"

namespace nodal::editing {

namespace {

// As lib's instances have them: at most so many of one range.
constexpr int kLongestRange = 1000;

Value constant(const std::string& value, const std::string& description) {
  return Value::Table{{"const", value}, {"description", description}};
}

// {grid = […]} or {count = …, from = …}; what stands in a grid is not looked at.
Value range_schema() {
  const Option grid = {.name = "grid", .type = OptionType::table, .help = "the values, one entry for each"};
  const OptionSchema counted = {
      {.name = "count",
       .type = OptionType::integer,
       .required = true,
       .minimum = 1,
       .maximum = kLongestRange,
       .help = "so many whole numbers, one entry for each"},
      {.name = "from", .type = OptionType::integer, .default_value = 1, .minimum = 0, .help = "the first of them"}};
  Value list = table_schema({}, Ranges::none);
  add_property(list, grid.name, Value::Table{{"type", "array"}, {"minItems", 1}, {"description", grid.help}});
  add_required(list, grid.name);
  Value schema = any_of({std::move(list), table_schema(counted, Ranges::none)});
  schema.set("description", "a range: the entry stands for one of each of its values");
  return schema;
}

// The keys that a kind's table has: the study's own, and those of the kind, which may be ranges.
Value problem_schema(const ProblemDescription& problem) {
  OptionSchema own = problem_entry_schema();
  std::erase_if(own, [](const Option& option) { return option.name == "kind"; });
  Value schema = table_schema(own, Ranges::none);
  add_property(schema, "kind", constant(problem.kind, problem.summary));
  add_required(schema, "kind");
  for (const Option& option : problem.options) {
    add_property(schema, option.name, value_schema(option, Ranges::allowed));
    if (option.required) add_required(schema, option.name);
  }
  return schema;
}

// The keys of an [[optimizer]] with what `use` and `options` may be.
Value optimizer_schema(Value use, Value options) {
  OptionSchema own = optimizer_entry_schema();
  std::erase_if(own, [](const Option& option) { return option.name == "use" || option.name == "options"; });
  Value schema = table_schema(own, Ranges::none);
  add_property(schema, "use", std::move(use));
  add_property(schema, "options", std::move(options));
  add_required(schema, "use");
  return schema;
}

Value any_table() { return Value::Table{{"type", "object"}}; }

// Some methods at once: labels and baselines are of one.
Value pattern_schema() {
  Value use = Value::Table{{"type", "string"},
                           {"pattern", "[*?\\[]"},
                           {"description", "every method of a name like that: * any signs, ? one, [ab] one of these"}};
  Value schema = optimizer_schema(std::move(use), any_table());
  Value properties = schema.at("properties");
  std::erase_if(properties.table(),
                [](const auto& entry) { return entry.first == "label" || entry.first == "baseline"; });
  schema.set("properties", std::move(properties));
  return schema;
}

std::string quoted_pattern(const std::string& name) {
  std::string pattern = "^";
  for (const char c : name.substr(0, name.find('*'))) pattern += c == '.' ? std::string("\\.") : std::string(1, c);
  return name.ends_with('*') ? pattern : pattern + "$";
}

// A method that this build lacks is left out of the race, whatever its options say.
Value absent_schema(const AbsentDescription& absent, const Registry& registry) {
  Value use = Value::Table{{"type", "string"},
                           {"pattern", quoted_pattern(absent.name)},
                           {"description", "left out by this build: " + absent.reason}};
  Value::List present;
  for (const OptimizerDescription& method : registry.optimizers()) present.emplace_back(method.name);
  use.set("not", Value::Table{{"enum", std::move(present)}});
  return optimizer_schema(std::move(use), any_table());
}

// Entries that an included file may complete: `key` says what they are, and may stand there.
Value unnamed(const std::string& key) {
  return Value::Table{{"type", "object"}, {"not", Value::Table{{"required", Value::List{key}}}}};
}

Value problem_definitions(Value& definitions, const Registry& registry) {
  Value::List kinds;
  for (const ProblemDescription& problem : registry.problems()) {
    definitions.set("problem " + problem.kind, problem_schema(problem));
    kinds.push_back(reference_to("problem " + problem.kind));
  }
  return Value(std::move(kinds));
}

Value optimizer_definitions(Value& definitions, const Registry& registry) {
  Value::List uses;
  for (const OptimizerDescription& method : registry.optimizers()) {
    const std::string name = "optimizer " + method.name;
    Value options = table_schema(method.options, Ranges::allowed);
    options.set("description", "the method's own options");
    definitions.set(name, optimizer_schema(constant(method.name, method.summary), std::move(options)));
    uses.push_back(reference_to(name));
  }
  uses.push_back(pattern_schema());
  for (const AbsentDescription& absent : registry.absent()) uses.push_back(absent_schema(absent, registry));
  return Value(std::move(uses));
}

// An entry, or a list of them.
Value entries(const std::string& definition, const std::string& description) {
  Value one = reference_to(definition);
  Value schema = any_of({one, Value::Table{{"type", "array"}, {"items", one}}});
  schema.set("description", description);
  return schema;
}

Value root_schema(const char* problem, const char* optimizer) {
  const Option include = {
      .name = "include", .type = OptionType::text_list, .help = "files whose tables this study takes and overrides"};
  Value schema = table_schema({include}, Ranges::none);
  add_property(schema, "study", table_schema(study_schema(), Ranges::none));
  add_property(schema, "budget", table_schema(budget_schema(), Ranges::none));
  add_property(schema, "problem", entries(problem, "what is optimized: [problem], or several [[problem]]"));
  add_property(schema, "optimizer", entries(optimizer, "who races: any number of [[optimizer]]"));
  return schema;
}

}  // namespace

std::string study_json_schema(const Registry& registry) {
  Value definitions;
  definitions.set("range", range_schema());
  const Value kinds = problem_definitions(definitions, registry), uses = optimizer_definitions(definitions, registry);
  definitions.set("problem", any_of(kinds.list()));
  definitions.set("optimizer", any_of(uses.list()));
  definitions.set("part of a problem", any_of({reference_to("problem"), unnamed("kind")}));
  definitions.set("part of an optimizer", any_of({reference_to("optimizer"), unnamed("use")}));
  Value whole = root_schema("problem", "optimizer"), part = root_schema("part of a problem", "part of an optimizer");
  Value properties = whole.at("properties");
  std::erase_if(properties.table(), [](const auto& entry) { return entry.first == "include"; });
  whole.set("properties", std::move(properties));
  add_required(whole, "problem");
  add_required(part, "include");
  Value schema = any_of({std::move(whole), std::move(part)});
  schema.set("$schema", "http://json-schema.org/draft-07/schema#");
  schema.set("title", "A study of nodal");
  schema.set("definitions", std::move(definitions));
  return to_json(schema);
}

}  // namespace nodal::editing
