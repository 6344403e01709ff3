// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A user's text as messages quote it.
///
/// Inputs can be long or no text at all: a key of 10 MB, a table in UTF-16, a control sequence. What is wrong with them
/// must still fit on a line of a terminal and do nothing to it.

#include <string>
#include <string_view>

namespace nodal {

/// How many bytes of a text a message quotes.
inline constexpr std::size_t kMostShown = 60;

/// At most `most` bytes of the text, whole characters, with "…" where it goes on; control characters, and bytes that
/// are no UTF-8, as "\x1B".
[[nodiscard]] std::string shown(std::string_view text, std::size_t most = kMostShown);

}  // namespace nodal
