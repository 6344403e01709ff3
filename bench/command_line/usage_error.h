// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is wrong with a call of the program, and what would be right.

#include <string>

#include <CLI/CLI.hpp>

namespace nodal {

/// "unknown option '--repeat' of nodal compare; did you mean '--repeats'?" and the like.
[[nodiscard]] std::string describe_usage_error(const CLI::App& app, const CLI::ParseError& error, int argc,
                                               const char* const* argv);

/// Accepts numbers above 0, in words that people read.
[[nodiscard]] CLI::Validator above_zero();
[[nodiscard]] CLI::Validator not_below_zero();

}  // namespace nodal
