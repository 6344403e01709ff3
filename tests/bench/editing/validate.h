// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Checks a value against a JSON schema of draft 7, of which it knows as much as studies' schema uses. A keyword that
/// it doesn't know is a std::logic_error: nothing is passed over.

#include <string>
#include <vector>

#include <nodal/value.h>

namespace nodal::editing {

/// What is wrong, each with its place: "/problem/kind: …"; empty where the value is as the schema says.
[[nodiscard]] std::vector<std::string> validate(const Value& schema, const Value& value);

}  // namespace nodal::editing
