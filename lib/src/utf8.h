// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace nodal {

/// How many bytes the well-formed UTF-8 character at the front of a text has (Unicode, table 3-7); 0 if there is none.
[[nodiscard]] std::size_t utf8_character_size(std::string_view text);

}  // namespace nodal
