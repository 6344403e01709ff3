// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a study takes from other files: `include = "common.toml"`, one name or several, at its top.
///
/// A study has the last word: tables that both have are joined key by key, deeper ones too, and its own values win.
/// Entries of [[problem]] and [[optimizer]] add up, those included first; a [problem] on both sides is one problem,
/// whose `best_known` is the study's own or none: the included one was of another. Included files may include others.
/// Their names are looked up beside the file that says them; files that a problem names (an outline, say) beside the
/// study.

#include <filesystem>
#include <optional>
#include <vector>

#include <nodal/study.h>
#include <nodal/value.h>

namespace nodal {

/// The study's tables with what they include, and what was read, in the order of reading. With `stored` the texts are
/// those, in that order, and no file is read. InputError where a file can't be read, includes itself, or lies more than
/// kMostIncludes deep, where there are more than kMostIncludedFiles, and where what is stored is not enough.
[[nodiscard]] Value with_includes(Value root, const std::filesystem::path& path,
                                  const std::optional<std::vector<IncludedFile>>& stored,
                                  std::vector<IncludedFile>& included);

inline constexpr std::size_t kMostIncludes = 16;
/// A file counts as often as it is included: a few that include each other twice would be read for hours.
inline constexpr std::size_t kMostIncludedFiles = 100;

}  // namespace nodal
