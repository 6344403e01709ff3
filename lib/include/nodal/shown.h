// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Texts from elsewhere as messages, terminals and records may hold them.
///
/// Inputs can be long or no text at all: a key of 10 MB, a table in UTF-16, a control sequence. What is wrong with them
/// must still fit on a line of a terminal and do nothing to it.

#include <cstddef>
#include <string>
#include <string_view>

namespace nodal {

/// How many bytes the well-formed UTF-8 character at the front of a text has (Unicode, table 3-7); 0 if there is none.
[[nodiscard]] std::size_t utf8_character_size(std::string_view text);

/// How many bytes at the end are the beginning of a character whose rest is still to come; at most 3.
[[nodiscard]] std::size_t unfinished_bytes(std::string_view text);

enum class Breaks { escape, keep };

/// UTF-8 without what a terminal obeys rather than shows: control characters (ESC, BEL, NUL, C1, …), line and paragraph
/// separators and the marks that turn the direction of writing become "\u001b", the way TOML and JSON write them, so
/// that JSON stays the same JSON. Line feeds and tabs become "\n" and "\t", or stay. Bytes that are no UTF-8 become
/// U+FFFD.
[[nodiscard]] std::string printable(std::string_view text, Breaks breaks = Breaks::escape);

/// How many bytes of a text a message quotes.
inline constexpr std::size_t kMostShown = 60;

/// A user's text as messages quote it: at most `most` bytes, whole characters, with "…" where it goes on. Printable,
/// but for bytes that are no UTF-8, which are told: "\xFF".
[[nodiscard]] std::string shown(std::string_view text, std::size_t most = kMostShown);

/// The text itself, or its beginning where it has more than `most` bytes: whole characters and "…".
[[nodiscard]] std::string beginning(std::string_view text, std::size_t most);

}  // namespace nodal
