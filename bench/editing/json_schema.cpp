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

constexpr const char* kPattern = "[*?\\[]";

std::string quoted_pattern(const std::string& name) {
  std::string pattern = "^";
  for (const char c : name.substr(0, name.find('*'))) pattern += c == '.' ? std::string("\\.") : std::string(1, c);
  return name.ends_with('*') ? pattern : pattern + "$";
}

// What `use` may be: a method of this build, a pattern, or what is left out of the race.
Value use_schema(const Registry& registry) {
  Value::List names;
  for (const OptimizerDescription& method : registry.optimizers()) names.emplace_back(method.name);
  Value::List kinds = {Value::Table{{"enum", std::move(names)}}, Value::Table{{"pattern", kPattern}}};
  for (const AbsentDescription& absent : registry.absent())
    kinds.emplace_back(Value::Table{{"pattern", quoted_pattern(absent.name)},
                                    {"description", "left out by this build: " + absent.reason}});
  Value schema = any_of(std::move(kinds));
  schema.set("type", "string");
  return schema;
}

// Methods whose options aren't known: some at once, of whom one can't have a label or be the baseline; those left out.
Value any_optimizer(bool pattern) {
  Value schema = optimizer_schema(Value::Table{{"type", "string"}}, any_table());
  std::erase_if(schema.table(), [](const auto& entry) { return entry.first == "required"; });
  if (!pattern) return schema;
  Value properties = schema.at("properties");
  std::erase_if(properties.table(),
                [](const auto& entry) { return entry.first == "label" || entry.first == "baseline"; });
  schema.set("properties", std::move(properties));
  return schema;
}

// An entry as its `key` says: that of the first name that it is, else `otherwise`. Not by "anyOf", of which an editor
// says only that it is none.
Value entry_schema(const char* what, const std::string& key, const std::vector<std::string>& names, Value words,
                   Value otherwise) {
  Value schema = std::move(otherwise);
  Value::List offers;
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    schema = choice(key_is(key, *name), reference_to(definition_name(what, *name)), std::move(schema));
  for (const std::string& name : names) offers.push_back(reference_to(definition_name(what, name)));
  schema.set("type", "object");
  schema.set("properties", Value::Table{{key, std::move(words)}});
  add_offers(schema, std::move(offers));
  return schema;
}

void define_problems(Value& definitions, const Registry& registry) {
  std::vector<std::string> kinds;
  for (const ProblemDescription& problem : registry.problems()) {
    definitions.set(definition_name("problem", problem.kind), problem_schema(problem));
    kinds.push_back(problem.kind);
  }
  Value words = Value::Table{{"enum", Value::List(kinds.begin(), kinds.end())}};
  definitions.set("problem", entry_schema("problem", "kind", kinds, std::move(words), Value()));
}

void define_optimizers(Value& definitions, const Registry& registry) {
  std::vector<std::string> uses;
  for (const OptimizerDescription& method : registry.optimizers()) {
    Value options = table_or_range(method.options);
    options.set("description", "the method's own options");
    definitions.set(definition_name("optimizer", method.name),
                    optimizer_schema(constant(method.name, method.summary), std::move(options)));
    uses.push_back(method.name);
  }
  Value is_pattern = requires_key("use");
  is_pattern.set("properties", Value::Table{{"use", Value::Table{{"pattern", kPattern}}}});
  definitions.set("optimizer", entry_schema("optimizer", "use", uses, use_schema(registry),
                                            choice(std::move(is_pattern), any_optimizer(true), any_optimizer(false))));
}

Value is_list() { return Value::Table{{"type", "array"}}; }

// An entry, or a list of them.
Value entries(const std::string& definition, const std::string& description) {
  const Value one = reference_to(definition), list = Value::Table{{"type", "array"}, {"items", one}};
  Value schema = choice(is_list(), list, one);
  add_offers(schema, {one, list});
  schema.set("description", description);
  return schema;
}

Value entries_with(const std::string& key) {
  return choice(is_list(), Value::Table{{"items", requires_key(key)}}, requires_key(key));
}

}  // namespace

std::string study_json_schema(const Registry& registry) {
  Value definitions;
  definitions.set("range", range_schema());
  define_problems(definitions, registry);
  define_optimizers(definitions, registry);
  const Option include = {
      .name = "include", .type = OptionType::text_list, .help = "files whose tables this study takes and overrides"};
  Value schema = table_schema({include}, Ranges::none);
  add_property(schema, "study", table_schema(study_schema(), Ranges::none));
  add_property(schema, "budget", table_schema(budget_schema(), Ranges::none));
  add_property(schema, "problem", entries("problem", "what is optimized: [problem], or several [[problem]]"));
  add_property(schema, "optimizer", entries("optimizer", "who races: any number of [[optimizer]]"));
  // What is included may say what is missing here.
  Value whole = requires_key("problem");
  whole.set("properties", Value::Table{{"problem", entries_with("kind")}, {"optimizer", entries_with("use")}});
  schema.set("if", requires_key("include"));
  schema.set("else", std::move(whole));
  schema.set("$schema", "http://json-schema.org/draft-07/schema#");
  schema.set("title", "A study of nodal");
  schema.set("definitions", std::move(definitions));
  return to_json(schema);
}

}  // namespace nodal::editing
