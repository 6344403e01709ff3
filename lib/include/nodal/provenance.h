// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where results come from: revision, compiler, flags, libraries, processor, environment. Stored with every run.

#include <string>
#include <utility>
#include <vector>

#include <nodal/value.h>

namespace nodal {

/// "0.1.0", and the revision with "-dirty" when the sources differed from it, or "unknown".
[[nodiscard]] std::string version();
[[nodiscard]] std::string revision();

/// Versions of the libraries that the registered components use, sorted by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> library_versions();
/// Called by a component's register function: ("CHOLMOD", "3.0.14"). Adding a name again replaces its version.
void add_library_version(const std::string& name, const std::string& version);

/// A table: revision, version, compiler, flags, build_type, libraries, executable (hash of the program's file), objects
/// (of the shared objects that it has loaded and that are not the system's), processor, threads, environment, system.
[[nodiscard]] Value provenance();

/// What of a provenance identifies the build (revision, compiler, flags, libraries, the program itself): results of
/// different builds should not be mixed.
[[nodiscard]] std::string build_identity(const Value& provenance);
/// The same as 16 hexadecimal digits, for records.
[[nodiscard]] std::string build_id(const Value& provenance);

}  // namespace nodal
