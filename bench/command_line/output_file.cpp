// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

void refuse_no_tables(const std::string& option, const std::string& path) {
  if (extension_of(path) != ".tex")
    throw InputError(Source{option, 0},
                     fmt::format("'{}' doesn't end in .tex; tables are a LaTeX file, e.g. tables.tex", path));
  refuse_unwritable(option, path);
}

void refuse_picture_of(const std::string& option, const std::string& path, const std::string& label,
                       const Exhibit& exhibit) {
  refuse_no_picture(option, path);
  if (!exhibit.draws()) throw InputError(Source{option, 0}, fmt::format("problem '{}' has no picture", label));
}

namespace {

bool may_have_any_name(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return path.starts_with("/dev/") || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

[[noreturn]] void refuse_format(const std::string& option, const std::string& path,
                                std::span<const ExportFormat> formats) {
  std::vector<std::string> extensions, summaries;
  for (const ExportFormat& format : formats) {
    extensions.push_back(format.extension);
    summaries.push_back(format.summary);
  }
  throw InputError(Source{option, 0},
                   fmt::format("'{}' doesn't end in {}; what is fitted is written as {}, e.g. fitted{}", path,
                               fmt::join(extensions, " or "), fmt::join(summaries, " or "), extensions.front()));
}

}  // namespace

ExportFormat export_format(const std::string& option, const std::string& path, std::span<const ExportFormat> formats) {
  auto found = std::ranges::find(formats, extension_of(path), &ExportFormat::extension);
  if (found == formats.end() && may_have_any_name(path)) found = formats.begin();
  if (found == formats.end()) refuse_format(option, path, formats);
  if (!found->lacks.empty())
    throw InputError(Source{option, 0}, fmt::format("writing '{}' as {} needs {}", path, found->summary, found->lacks));
  refuse_unwritable(option, path);
  return *found;
}

bool is_standard_output(const std::string& path) {
  struct stat named = {};
  struct stat out = {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(STDOUT_FILENO, &out) == 0 && named.st_dev == out.st_dev &&
         named.st_ino == out.st_ino;
}

}  // namespace nodal
