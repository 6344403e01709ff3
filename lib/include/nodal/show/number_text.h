// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Numbers as people read them: a few digits, a unit by magnitude.

#include <cstddef>
#include <string>
#include <string_view>

namespace nodal {

/// Significant digits, plain between 1e-4 and 1e6, else "1.2e-9"; trailing zeros stay, so that columns compare.
[[nodiscard]] std::string figure_text(double value, int digits);
/// The double nearest to `value` written with so many significant digits; subnormal ones, too.
[[nodiscard]] double rounded(double value, int digits);
/// "430 ns", "1.72 ms", "12.3 s", "2.5 min": three digits.
[[nodiscard]] std::string seconds_text(double seconds);
/// "12,345", "1.25 M", "3.40 G"; a median between two counts is rounded.
[[nodiscard]] std::string count_text(double count);
/// "12.4×"; two digits below 1.
[[nodiscard]] std::string multiple_text(double multiple);
/// 0.01 as "0.01", 1e-6 as "1e-6": a gap as it is spoken of.
[[nodiscard]] std::string gap_text(double gap);

/// Columns that a terminal needs for UTF-8 text: combining marks none, East Asian wide characters two.
[[nodiscard]] std::size_t display_width(std::string_view text);

}  // namespace nodal
