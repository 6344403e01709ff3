// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How the lines of a chart are told apart: twenty colours, each with a twin for dark pages, and dashes.
///
/// The colours were chosen one after the other, each as far as possible from those before it (OKLab), by whoever sees
/// all colours, no red or no green (Machado, Oliveira & Fernandes 2009), on white and on the dark page alike. All have
/// a contrast of 3 to 1 or more with their page (WCAG 2.1, 1.4.11). A style's number is all that a page says of it: its
/// style sheet has the colour.

#include <cstddef>
#include <string>
#include <string_view>

namespace nodal::report {

struct LineStyle {
  std::string_view light, dark;  ///< colours
  std::string_view dash;         ///< as stroke-dasharray has it; empty for a solid line
};

inline constexpr std::size_t kLineColours = 20;

/// Beyond the last colour they begin again, in other dashes.
[[nodiscard]] LineStyle line_style(std::size_t style) noexcept;
/// Black, or white on a dark page.
[[nodiscard]] LineStyle baseline_style() noexcept;

/// Of an element that has the colour as its own: "s3", "base".
[[nodiscard]] std::string style_class(std::size_t style, bool baseline);
/// For a page: variables --s0, …, --base, and classes that paint with them.
[[nodiscard]] std::string line_styles_css();

}  // namespace nodal::report
