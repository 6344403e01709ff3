// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// TOML as a Value; every value knows its file and line. InputError for syntax errors, dates and times.

#include <string>
#include <string_view>

#include <nodal/value.h>

namespace nodal {

[[nodiscard]] Value parse_toml(std::string_view text, const std::string& file_name);

}  // namespace nodal
