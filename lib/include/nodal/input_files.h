// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The files that a problem is read from: the one way to read what a study names, so that whatever was read is known.
///
/// Threads  one at a time.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nodal {

class InputFiles {
 public:
  /// Relative names are looked up in `directory`: the study's.
  explicit InputFiles(std::filesystem::path directory = {}) : directory_(std::move(directory)) {}

  /// Where a file lies that a study calls `name`.
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  /// The contents of the file at `path`; each is read once. InputError as read_file (file.h) has it; `what` is "node
  /// file", "outline file", ….
  [[nodiscard]] const std::string& read(const std::filesystem::path& path, std::string_view what);
  /// A hash of the contents of all that was read, in the order in which it was first asked for; empty without any.
  /// Names don't count: a problem is the same wherever its files lie.
  [[nodiscard]] std::string fingerprint() const;

 private:
  using Key = std::pair<std::string, std::string>;  // path, what
  std::filesystem::path directory_;
  std::map<Key, std::string> contents_;
  std::vector<const std::string*> order_;
};

}  // namespace nodal
