// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/shown.h>

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "escaped.h"

namespace nodal {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// Of a whole character.
std::uint32_t code_of(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  std::uint32_t code = character.size() == 1 ? lead : lead & (0x7Fu >> character.size());
  for (const char c : character.substr(1)) code = (code << 6) | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

bool obeyed(std::uint32_t c) {
  const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  const bool separator = c == 0x2028 || c == 0x2029;
  const bool direction =
      c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return control || separator || direction;
}

// Takes the character at the front off the text; `whole` is false where that is a byte that is no UTF-8.
std::string_view take_character(std::string_view& text, bool& whole) {
  const std::size_t size = utf8_character_size(text);
  whole = size > 0;
  const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
  text.remove_prefix(character.size());
  return character;
}

}  // namespace

std::size_t utf8_character_size(std::string_view text) {
  const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto between = [](unsigned value, unsigned least, unsigned most) { return least <= value && value <= most; };
  const auto continues = [&](std::size_t i) { return between(byte(i), 0x80, 0xBF); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (between(lead, 0xC2, 0xDF)) return continues(1) ? 2 : 0;
  if (between(lead, 0xE0, 0xEF)) {  // neither longer than needed nor half of a surrogate pair
    const bool second = between(byte(1), lead == 0xE0 ? 0xA0 : 0x80, lead == 0xED ? 0x9F : 0xBF);
    return second && continues(2) ? 3 : 0;
  }
  if (between(lead, 0xF0, 0xF4)) {  // neither longer than needed nor beyond U+10FFFF
    const bool second = between(byte(1), lead == 0xF0 ? 0x90 : 0x80, lead == 0xF4 ? 0x8F : 0xBF);
    return second && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

std::size_t unfinished_bytes(std::string_view text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const auto c = static_cast<unsigned char>(text[text.size() - back]);
    if ((c & 0xC0u) == 0x80u) continue;  // goes on with a character
    const std::size_t size = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : c >= 0xC0 ? 2 : 1;
    return size > back ? back : 0;
  }
  return 0;
}

std::string escaped(std::string_view character) {
  const std::uint32_t code = code_of(character);
  if (!obeyed(code)) return std::string(character);
  switch (code) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return fmt::format("\\u{:04x}", code);
  }
}

std::string printable(std::string_view text, Breaks breaks) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    bool whole = false;
    const std::string_view character = take_character(text, whole);
    const bool kept = breaks == Breaks::keep && (character == "\n" || character == "\t");
    result += !whole ? std::string(kReplacement) : kept ? std::string(character) : escaped(character);
  }
  return result;
}

std::string shown(std::string_view text, std::size_t most) {
  std::string out;
  while (!text.empty()) {
    bool whole = false;
    const std::string_view character = take_character(text, whole);
    const std::string next =
        whole ? escaped(character) : fmt::format("\\x{:02X}", static_cast<unsigned char>(character[0]));
    if (out.size() + next.size() > most) return out + "…";
    out += next;
  }
  return out;
}

std::string beginning(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t size = 0;
  for (std::string_view rest = text; size < most;) {
    bool whole = false;
    const std::size_t next = take_character(rest, whole).size();
    if (size + next > most) break;
    size += next;
  }
  return std::string(text.substr(0, size)) + "…";
}

}  // namespace nodal
