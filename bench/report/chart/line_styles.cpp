// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_styles.h"

#include <array>

#include <fmt/format.h>

namespace nodal::report {

namespace {

struct Twins {
  std::string_view light, dark;
};

constexpr std::array<Twins, kLineColours> kColours = {{
    {"#3471b2", "#70aff4"}, {"#be1506", "#fe6d5a"}, {"#620a6b", "#a04ea8"}, {"#2315c2", "#4f6bfb"},
    {"#4d9d61", "#8cdd9e"}, {"#572416", "#945b4b"}, {"#7c4b6a", "#bb85a6"}, {"#9589bf", "#d3c8ff"},
    {"#5c7f7d", "#98bdbb"}, {"#4c4a95", "#8485d6"}, {"#503e51", "#8a758b"}, {"#a2790d", "#e2b75c"},
    {"#46683b", "#80a474"}, {"#789b93", "#b6dad2"}, {"#3e228a", "#7260cb"}, {"#1d8350", "#65c18b"},
    {"#905496", "#d090d6"}, {"#5e1040", "#9d4c78"}, {"#822d22", "#c4685a"}, {"#0f46e1", "#6293ff"},
}};
constexpr Twins kBaseline = {"#111111", "#f2f2f2"};

// The first seven are solid, the next dashed, …
constexpr std::array<std::string_view, 4> kDashes = {"", "7 3", "2 2", "9 3 2 3"};
constexpr std::size_t kAlike = 7;

std::string variables(std::string_view Twins::*theme) {
  std::string text = ":root {";
  for (std::size_t i = 0; i < kColours.size(); ++i) text += fmt::format(" --s{}: {};", i, kColours[i].*theme);
  return text + fmt::format(" --base: {}; }}\n", kBaseline.*theme);
}

}  // namespace

LineStyle line_style(std::size_t style) noexcept {
  const Twins& colour = kColours[style % kColours.size()];
  return {colour.light, colour.dark, kDashes[style / kAlike % kDashes.size()]};
}

LineStyle baseline_style() noexcept { return {kBaseline.light, kBaseline.dark, ""}; }

std::string style_class(std::size_t style, bool baseline) {
  return baseline ? "base" : fmt::format("s{}", style % kColours.size());
}

std::string line_styles_css() {
  std::string text =
      variables(&Twins::light) + "@media screen and (prefers-color-scheme: dark) { " + variables(&Twins::dark) + "}\n";
  for (std::size_t i = 0; i < kColours.size(); ++i)
    text += fmt::format(".s{0} {{ stroke: var(--s{0}); fill: var(--s{0}); }}\n", i);
  return text + ".base { stroke: var(--base); fill: var(--base); }\n";
}

}  // namespace nodal::report
