// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal {

void refuse_unwritable(const std::string& option, const std::string& path) {
  std::error_code error;
  const bool there = std::filesystem::exists(path, error);
  std::ofstream out(path, std::ios::binary | std::ios::app);
  if (!out)
    throw InputError(Source{option, 0},
                     fmt::format("cannot write '{}'; give a file in a folder that exists and may be written", path));
  out.close();
  if (!there) std::filesystem::remove(path, error);
}

void refuse_no_picture(const std::string& option, const std::string& path) {
  if (!path.ends_with(".svg"))
    throw InputError(Source{option, 0},
                     fmt::format("'{}' doesn't end in .svg; pictures are SVG files, e.g. plate.svg", path));
  refuse_unwritable(option, path);
}

}  // namespace nodal
