// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What all harnesses do: read a text, and take a refusal for an answer.
///
/// Anything but an InputError, a sanitizer's complaint, a hang or a leak ends the run with the text that caused it.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <nodal/error.h>

namespace nodal::fuzz {

template <class Read>
int read(const std::uint8_t* data, std::size_t size, Read&& reader) {
  try {
    reader(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const InputError&) {
  }
  return 0;
}

}  // namespace nodal::fuzz
