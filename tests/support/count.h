// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How often a text has a part.

#include <string_view>

namespace nodal::toy {

/// Without overlaps.
inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

}  // namespace nodal::toy
