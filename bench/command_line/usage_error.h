// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is wrong with a call of the program, and what would be right.

#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

namespace nodal {

/// "unknown option '--repeat' of nodal compare; did you mean '--repeats'?" and the like.
[[nodiscard]] std::string describe_usage_error(const CLI::App& app, const CLI::ParseError& error, int argc,
                                               const char* const* argv);

/// Accepts numbers above 0, in words that people read.
[[nodiscard]] CLI::Validator above_zero();
[[nodiscard]] CLI::Validator not_below_zero();
/// Whole numbers from `least` on that 63 bits hold: what is larger would become another number without a word.
[[nodiscard]] CLI::Validator whole_number_from(std::int64_t least);
/// Refuses empty texts wherever an option or argument takes one: a variable of a script that isn't set.
void refuse_empty_texts(CLI::App& app);

}  // namespace nodal
