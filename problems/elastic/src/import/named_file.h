// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The files that options name.

#include <filesystem>

#include <nodal/input_files.h>
#include <nodal/value.h>

namespace nodal::elastic {

/// Where the file lies that an option names. InputError at the option's place where there is none; what else is wrong
/// with it is told by who reads it.
[[nodiscard]] std::filesystem::path named_file(const InputFiles& files, const Value& option);

}  // namespace nodal::elastic
