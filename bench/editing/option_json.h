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

/// Adds a key to what table_schema made.
void add_property(Value& table, const std::string& key, Value schema);
/// Says that keys must be there.
void add_required(Value& table, const std::string& key);

/// {"anyOf": [a, b, …]}.
[[nodiscard]] Value any_of(Value::List schemas);
/// {"$ref": "#/definitions/NAME"}.
[[nodiscard]] Value reference_to(const std::string& name);

}  // namespace nodal::editing
