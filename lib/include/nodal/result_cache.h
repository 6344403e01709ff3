// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What takes long to make and is determined by what it is made of, kept from one run of the program to the next.
///
/// A file for each, named by a hash of all that determines it and of the program that made it: another build makes its
/// own. One that is missing, cut off, garbled or of something else counts as not there. Nothing depends on it but time,
/// so that what can't be written is not kept, and nobody is told.
///
/// Threads  any number of threads and processes: a file is replaced as a whole.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace nodal {

class ResultCache {
 public:
  /// Keeps nothing.
  ResultCache() = default;
  /// In a directory, which is made when something is kept.
  explicit ResultCache(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// What was kept of this origin: a text that says everything it was made of.
  [[nodiscard]] std::optional<std::string> find(std::string_view origin) const;
  void keep(std::string_view origin, std::string_view text) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view origin) const;

  std::filesystem::path directory_;
};

}  // namespace nodal
