// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/file.h>

namespace nodal {

namespace fs = std::filesystem;

namespace {

// Where a name leads: through links, also one whose target is yet to be made.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return fs::canonical(path, error);
  if (fs::is_symlink(path, error)) return path.parent_path() / fs::read_symlink(path, error);
  return path;
}

// Empty when replace_file can write there.
std::string why_not(const fs::path& path) {
  std::error_code error;
  const fs::path target = target_of(path);
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) return "it is a folder";
  if (fs::exists(status) && !fs::is_regular_file(status))
    return ::access(target.c_str(), W_OK) == 0 ? "" : "it may not be written";
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) return fmt::format("there is no folder '{}'", folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return fmt::format("the folder '{}' may not be written", folder.string());
  return {};
}

}  // namespace

void refuse_unwritable(const std::string& option, const std::string& path) {
  if (const std::string why = why_not(path); !why.empty())
    throw InputError(
        Source{option, 0},
        fmt::format("cannot write '{}': {}; give a file in a folder that exists and may be written", path, why));
}

void refuse_no_picture(const std::string& option, const std::string& path) {
  if (extension_of(path) != ".svg")
    throw InputError(Source{option, 0},
                     fmt::format("'{}' doesn't end in .svg; pictures are SVG files, e.g. plate.svg", path));
  refuse_unwritable(option, path);
}

void refuse_no_system(const std::string& option, const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const bool special =
      path.starts_with("/dev/") || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
  if (!special && extension_of(path) != ".json")
    throw InputError(
        Source{option, 0},
        fmt::format("'{}' doesn't end in .json; what is fitted is written as JSON, e.g. fitted.json", path));
  refuse_unwritable(option, path);
}

bool is_standard_output(const std::string& path) {
  struct stat named {}, out {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(STDOUT_FILENO, &out) == 0 && named.st_dev == out.st_dev &&
         named.st_ino == out.st_ino;
}

}  // namespace nodal
