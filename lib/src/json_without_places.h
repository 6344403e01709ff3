// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <nodal/value.h>

namespace nodal {

/// As parse_json, but no value says where it was said. A store has millions of values, and each a copy of its file's
/// name took a good part of the time of a report. InputError tells name and line all the same.
[[nodiscard]] Value parse_json_without_places(std::string_view text, const std::string& name);

}  // namespace nodal
