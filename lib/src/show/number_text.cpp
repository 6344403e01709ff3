// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/show/number_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

namespace nodal {

namespace {

// The power of ten of a value rounded to so many digits: 9.996 to three digits is 10.0, whose power is 1.
int rounded_power(double value, int digits) {
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  return std::stoi(scientific.substr(scientific.find('e') + 1));
}

// "1.20e-09" as "1.20e-9".
std::string short_exponent(const std::string& text) {
  const std::size_t e = text.find('e');
  return text.substr(0, e + 1) + std::to_string(std::stoi(text.substr(e + 1)));
}

std::string with_commas(std::string digits) {
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

struct CodePoints {
  std::uint32_t first, last;
};
constexpr std::array<CodePoints, 5> kCombining = {
    {{0x300, 0x36F}, {0x1AB0, 0x1AFF}, {0x20D0, 0x20FF}, {0x200B, 0x200D}, {0xFE00, 0xFE0F}}};
constexpr std::array<CodePoints, 6> kWide = {
    {{0x1100, 0x115F}, {0x2E80, 0xA4CF}, {0xAC00, 0xD7A3}, {0xF900, 0xFAFF}, {0xFF00, 0xFF60}, {0x1F300, 0x1FAFF}}};

template <std::size_t N>
bool contains(const std::array<CodePoints, N>& ranges, std::uint32_t c) {
  return std::ranges::any_of(ranges, [c](const CodePoints& r) { return r.first <= c && c <= r.last; });
}

}  // namespace

std::string figure_text(double value, int digits) {
  if (!std::isfinite(value)) return value > 0.0 ? "∞" : "?";
  if (value == 0.0) return "0";
  const int power = rounded_power(value, digits);
  if (power < -4 || power >= 6) return short_exponent(fmt::format("{:.{}e}", value, digits - 1));
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - power));
}

// Not by std::stod, which throws where a subnormal number is read.
double rounded(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

std::string seconds_text(double seconds) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr std::array<Unit, 4> kUnits = {{{1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}, {1.0, "s"}}};
  if (seconds >= 600.0) return figure_text(seconds / 60.0, 3) + " min";
  for (const Unit& unit : kUnits)
    if (seconds < 999.5 * unit.size || unit.size == 1.0) {
      const double value = seconds / unit.size;
      // Below a nanosecond nothing is meant but "no time at all".
      return value < 0.5e-3 ? "0 s" : figure_text(value, 3) + " " + unit.name;
    }
  return {};
}

std::string count_text(double count) {
  if (count < 999'999.5) return with_commas(fmt::format("{:.0f}", count));
  if (count < 999.5e6) return figure_text(count / 1e6, 3) + " M";
  return figure_text(count / 1e9, 3) + " G";
}

std::string multiple_text(double multiple) { return figure_text(multiple, multiple < 1.0 ? 2 : 3) + "×"; }

std::string gap_text(double gap) {
  return gap >= 1e-3 ? fmt::format("{:g}", gap) : short_exponent(fmt::format("{:.0e}", gap));
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    std::uint32_t code = length == 1 ? lead : lead & (0x7Fu >> length);
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
      code = (code << 6) | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
    width += contains(kCombining, code) ? 0 : contains(kWide, code) ? 2 : 1;
    i += length;
  }
  return width;
}

}  // namespace nodal
