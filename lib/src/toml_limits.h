// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a TOML text may hold, looked at before it is parsed.
///
/// toml++ bounds nested brackets but neither the dots of keys and of [table.headers], each of which is a table within a
/// table that it destroys by recursion, nor memory: a number of two bytes costs some hundred.

#include <cstddef>
#include <string>
#include <string_view>

namespace nodal {

/// Tables and lists within each other; more is an attack on the stack, not data.
inline constexpr std::size_t kDeepestToml = 200;
/// [bytes]
inline constexpr std::size_t kLargestToml = 8'000'000;

/// InputError with the line for a text beyond these limits. Texts that are no TOML go through, unless they are beyond
/// them: toml++ says better what is wrong.
void refuse_beyond_limits(std::string_view text, const std::string& file_name);

}  // namespace nodal
