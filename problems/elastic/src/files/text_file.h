// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whole files as text.

#include <filesystem>
#include <string>

namespace nodal::elastic {

/// The contents of a file; `what` names it in the message: "stiffness file". InputError when it can't be read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, const std::string& what);

}  // namespace nodal::elastic
