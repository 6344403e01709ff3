// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/shown.h>

#include "utf8.h"

namespace nodal {

namespace {

// A terminal takes U+0080 to U+009F for control characters, too.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
  return character.size() == 2 && byte(0) == 0xC2 && byte(1) < 0xA0;
}

void escape(std::string_view bytes, std::string& out) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out += "\\x";
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t whole = utf8_character_size(text.substr(at));
    const std::string_view character = text.substr(at, whole > 0 ? whole : 1);
    std::string next;
    if (whole == 0 || is_control(character))
      escape(character, next);
    else
      next = character;
    if (out.size() + next.size() > most) return out + "…";
    out += next;
    at += character.size();
  }
  return out;
}

}  // namespace nodal
