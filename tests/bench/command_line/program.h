// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Runs the program as a user does, in a folder of the test's own.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace nodal::program {

struct Output {
  int exit = -1;  ///< exit code, or 128 + signal
  std::string out, err;
};

/// An empty folder that goes when this goes.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  /// Writes a file into it and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// Where stdout of a program goes.
enum class Stdout {
  file,      ///< a file of the folder, as stderr always does unless said otherwise
  full,      ///< a device without room
  closed,    ///< nowhere
  gone,      ///< a pipe that nobody reads any more
  both_gone  ///< stderr, too
};

/// A program that has been started and not yet waited for; stdout and stderr go to files of `folder`.
class Started {
 public:
  Started(const Folder& folder, const std::vector<std::string>& arguments, Stdout out = Stdout::file);
  [[nodiscard]] pid_t process() const noexcept { return process_; }
  Output wait();

 private:
  const Folder& folder_;
  pid_t process_;
};

/// Starts in `folder` and waits.
Output run(const Folder& folder, const std::vector<std::string>& arguments, Stdout out = Stdout::file);

[[nodiscard]] std::string read_file(const std::filesystem::path& path);
[[nodiscard]] std::size_t count_lines(const std::filesystem::path& directory);  ///< of all its *.jsonl files
/// Waits until a directory's *.jsonl files have that many lines, but not for ever: false after half a minute.
[[nodiscard]] bool wait_for_lines(const std::filesystem::path& directory, std::size_t wanted);
[[nodiscard]] bool contains(const std::string& text, const std::string& part);

}  // namespace nodal::program
