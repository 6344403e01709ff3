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

void refuse_unwritable(const std::string& option, const std::string& path) {
  if (const std::string why = replace_refusal(path); !why.empty())
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
  struct stat named = {};
  struct stat out = {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(STDOUT_FILENO, &out) == 0 && named.st_dev == out.st_dev &&
         named.st_ino == out.st_ino;
}

}  // namespace nodal
