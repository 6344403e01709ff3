// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace nodal {

/// Removes the files "NAME.DIGITS.PROCESS.part" that `replace_file` (file.h) wrote beside NAME in a process that died
/// before it could rename them: that process is no more, and the file is older than a minute (another machine may write
/// here).
void remove_leftovers(const std::filesystem::path& directory) noexcept;

}  // namespace nodal
