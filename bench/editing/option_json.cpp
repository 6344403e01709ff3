// SPDX-License-Identifier: GPL-3.0-or-later
#include "option_json.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace nodal::editing {

namespace {

Value of_type(const char* type) { return Value::Table{{"type", type}}; }

Value number_schema(const Option& option, const char* type) {
  Value schema = of_type(type);
  if (std::isfinite(option.minimum))
    schema.set(option.minimum_excluded ? "exclusiveMinimum" : "minimum", Value(option.minimum));
  if (std::isfinite(option.maximum))
    schema.set(option.maximum_excluded ? "exclusiveMaximum" : "maximum", Value(option.maximum));
  return schema;
}

Value text_schema(const Option& option) {
  Value schema = of_type("string");
  if (!option.choices.empty()) schema.set("enum", Value::List(option.choices.begin(), option.choices.end()));
  return schema;
}

Value list_schema(Value items, std::size_t least, std::size_t most) {
  Value schema = of_type("array");
  schema.set("items", std::move(items));
  if (least > 0) schema.set("minItems", std::uint64_t{least});
  if (most > 0) schema.set("maxItems", std::uint64_t{most});
  return schema;
}

Value or_range(Value schema, Ranges ranges) {
  return ranges == Ranges::none ? std::move(schema) : any_of({std::move(schema), reference_to("range")});
}

Value list_of_items(const Option& option, Value item) {
  const std::size_t most = option.length > 0 ? std::max(option.length, option.longest) : 0;
  return list_schema(std::move(item), option.length, most);
}

Value list_of(const Option& option, Value item, Ranges ranges) {
  return list_of_items(option, or_range(std::move(item), ranges));
}

Value table_of(const Option& option, Ranges ranges) {
  if (option.fields.empty()) return of_type("object");
  return ranges == Ranges::allowed ? table_or_range(option.fields) : table_schema(option.fields, ranges);
}

Value vector_schema(const Option& option, Ranges ranges) {
  return list_schema(or_range(number_schema(option, "number"), ranges), option.entries[0], option.entries[1]);
}

// Without what people read of it, and without the table or the range that may stand in its place.
Value plain_schema(const Option& option, Ranges ranges) {
  switch (option.type) {
    case OptionType::boolean:
      return of_type("boolean");
    case OptionType::integer:
      return number_schema(option, "integer");
    case OptionType::number:
      return number_schema(option, "number");
    case OptionType::text:
      return text_schema(option);
    case OptionType::number_list:
      return list_of(option, number_schema(option, "number"), ranges);
    case OptionType::integer_list:
      return list_of(option, number_schema(option, "integer"), ranges);
    case OptionType::text_list:
      return any_of({text_schema(option), list_of(option, text_schema(option), ranges)});
    case OptionType::vector_list:
      return list_of(option, vector_schema(option, ranges), ranges);
    case OptionType::vector_lists:
      return list_of(option, list_schema(or_range(vector_schema(option, ranges), ranges), 0, 0), ranges);
    case OptionType::table:
      return table_of(option, ranges);
    case OptionType::table_list:
      return list_of_items(option, table_of(option, ranges));
  }
  return Value();
}

std::string description_of(const Option& option) {
  std::string text = option.help;
  if (!option.unit.empty()) text += fmt::format(" [{}]", option.unit);
  if (!option.default_text.empty()) text += fmt::format(" (default: {})", option.default_text);
  return text;
}

}  // namespace

Value any_of(Value::List schemas) { return Value::Table{{"anyOf", std::move(schemas)}}; }

void add_offers(Value& schema, Value::List schemas) {
  schemas.emplace_back();
  schema.set("anyOf", std::move(schemas));
}

Value choice(Value condition, Value then, Value otherwise) {
  return Value::Table{{"if", std::move(condition)}, {"then", std::move(then)}, {"else", std::move(otherwise)}};
}

Value requires_key(const std::string& key) { return Value::Table{{"required", Value::List{key}}}; }

Value key_is(const std::string& key, const std::string& value) {
  Value condition = requires_key(key);
  condition.set("properties", Value::Table{{key, Value::Table{{"const", value}}}});
  return condition;
}

std::string definition_name(const std::string& what, const std::string& name) {
  std::string text = what + "-";
  for (const char c : name) text += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
  return text;
}

Value reference_to(const std::string& name) { return Value::Table{{"$ref", "#/definitions/" + name}}; }

Value value_schema(const Option& option, Ranges ranges) {
  Value schema = plain_schema(option, ranges);
  if (option.or_table) schema = any_of({std::move(schema), table_or_range(option.fields)});
  if (option.type != OptionType::table && !option.or_table) schema = or_range(std::move(schema), ranges);
  if (const std::string text = description_of(option); !text.empty()) schema.set("description", text);
  if (option.default_value) schema.set("default", *option.default_value);
  return schema;
}

void add_property(Value& table, const std::string& key, Value schema) {
  Value properties = table.at("properties");
  properties.set(key, std::move(schema));
  table.set("properties", std::move(properties));
}

void add_required(Value& table, const std::string& key) {
  Value::List keys = table.find("required") ? table.at("required").list() : Value::List{};
  keys.emplace_back(key);
  table.set("required", std::move(keys));
}

Value table_schema(const OptionSchema& options, Ranges ranges) {
  Value properties;
  for (const Option& option : options) properties.set(option.name, value_schema(option, ranges));
  Value schema = of_type("object");
  schema.set("properties", std::move(properties));
  schema.set("additionalProperties", false);
  for (const Option& option : options)
    if (option.required) add_required(schema, option.name);
  return schema;
}

Value table_or_range(const OptionSchema& options) {
  Value schema = table_schema(options, Ranges::allowed);
  const Value range_keys = Value::Table{{"grid", Value::Table{{"type", "array"}, {"minItems", 1}}},
                                        {"count", Value::Table{{"type", "integer"}, {"minimum", 1}}},
                                        {"from", Value::Table{{"type", "integer"}, {"minimum", 0}}}};
  for (const auto& [key, value] : range_keys.table()) add_property(schema, key, value);
  if (!schema.find("required")) return schema;
  // What a table must have, a range needn't.
  const Value required = Value::Table{{"required", schema.at("required")}};
  std::erase_if(schema.table(), [](const auto& entry) { return entry.first == "required"; });
  schema.set("if", any_of({requires_key("grid"), requires_key("count")}));
  schema.set("else", required);
  return schema;
}

}  // namespace nodal::editing
