// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Options as parts of a JSON schema.

#include <string>

#include <nodal/options.h>

namespace nodal::editing {

/// Whether values may be ranges, which make several entries of one: then "#/definitions/range" must be defined.
enum class Ranges { none, allowed };

/// What is allowed for an option: {"type": …, "description": …, "default": …}.
[[nodiscard]] Value value_schema(const Option& option, Ranges ranges);

/// "properties" and what belongs to it of a table with these keys and no others; keys may be added to it.
[[nodiscard]] Value table_schema(const OptionSchema& options, Ranges ranges);
/// The same, or a range in the table's place: one schema of both, so that an editor marks the key that is wrong and not
/// all that it stands in.
[[nodiscard]] Value table_or_range(const OptionSchema& options);

/// Adds a key to what table_schema made.
void add_property(Value& table, const std::string& key, Value schema);
/// Says that keys must be there.
void add_required(Value& table, const std::string& key);

/// {"anyOf": [a, b, …]}.
[[nodiscard]] Value any_of(Value::List schemas);
/// Adds what an editor offers to complete and what it doesn't check: an "anyOf" that everything is one of.
void add_offers(Value& schema, Value::List schemas);
/// {"if": a, "then": b, "else": c}.
[[nodiscard]] Value choice(Value condition, Value then, Value otherwise);
/// The condition that a table's `key` is `value`.
[[nodiscard]] Value key_is(const std::string& key, const std::string& value);
/// {"required": [KEY]}.
[[nodiscard]] Value requires_key(const std::string& key);
/// "problem-elastic": what a reference may be called, which is an address without blanks.
[[nodiscard]] std::string definition_name(const std::string& what, const std::string& name);
/// {"$ref": "#/definitions/NAME"}.
[[nodiscard]] Value reference_to(const std::string& name);

}  // namespace nodal::editing
