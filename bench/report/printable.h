// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Text that comes from studies, stores and exceptions, as a terminal may see it.

#include <cstddef>
#include <string>
#include <string_view>

namespace nodal::report {

enum class Breaks { escape, keep };

/// UTF-8 without what a terminal obeys rather than shows: control characters (ESC, BEL, NUL, C1, …), line and paragraph
/// separators and the marks that turn the direction of writing become "\u001b", the way TOML and JSON write them, so
/// that JSON stays the same JSON. Line feeds and tabs become "\n" and "\t", or stay. Bytes that are no UTF-8 become
/// U+FFFD.
[[nodiscard]] std::string printable(std::string_view text, Breaks breaks = Breaks::escape);

/// How many bytes at the end are the beginning of a character whose rest is still to come; at most 3.
[[nodiscard]] std::size_t unfinished_bytes(std::string_view text);

}  // namespace nodal::report
