// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Who may include whom.
///
/// A unit is lib, bench, or a folder of problems or optimizers. Rules:
///   lib includes only itself, the standard library, the system, and the few libraries it stands on;
///   a problem or an optimizer includes lib's public headers, itself, and libraries of its own;
///   bench includes lib's public headers and itself: it knows no problem and no optimizer;
///   a public header (below an include/ folder) includes nothing but the standard library and public headers;
///   <nodal/components.h> is for programs: bench, and the micro-benchmarks of a component, its folder micro/;
///   nobody includes by a path that leaves its unit, nor asks the preprocessor what is in the build;
///   nobody catches std::invalid_argument, which means a bug: what can't be had is a Refusal (error.h);
///   every source begins with the licence.

#include <filesystem>
#include <string>
#include <vector>

namespace nodal::architecture {

/// Every breach in the tree below `root`, as "file:line: what"; files in alphabetical order.
[[nodiscard]] std::vector<std::string> find_breaches(const std::filesystem::path& root);

/// How many sources `find_breaches` would read: a checker that reads nothing finds nothing.
[[nodiscard]] std::size_t count_sources(const std::filesystem::path& root);

}  // namespace nodal::architecture
