// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace nodal {

/// Where the scenes are: beside an installed program, else where the sources are.
[[nodiscard]] std::filesystem::path scenes_directory();

}  // namespace nodal
