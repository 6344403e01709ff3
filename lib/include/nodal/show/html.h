// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How text gets into a page safely.

#include <string>
#include <string_view>

namespace nodal {

/// Text for element content and quoted attributes.
[[nodiscard]] std::string escape_html(std::string_view text);
/// JSON for a <script> element: no "<" is left in it, so nothing in it can end the element.
[[nodiscard]] std::string escape_script(std::string json);

}  // namespace nodal
