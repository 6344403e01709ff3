// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace nodal {

/// One UTF-8 character: itself, or what it is written as where a terminal would obey it ("\n", "\u001b"): the one way
/// in which the toolkit writes such characters.
[[nodiscard]] std::string escaped(std::string_view character);

}  // namespace nodal
