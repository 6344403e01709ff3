// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// TOML as a Value; every value knows its file and line. InputError for syntax errors, dates and times, more than 200
/// tables or lists within each other (each dot of a key is one), and texts of more than 8 MB.

#include <string>
#include <string_view>

#include <nodal/value.h>

namespace nodal {

[[nodiscard]] Value parse_toml(std::string_view text, const std::string& file_name);

}  // namespace nodal
