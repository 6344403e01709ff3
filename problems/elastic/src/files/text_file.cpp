// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic {

std::string read_text_file(const std::filesystem::path& path, const std::string& what) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in || std::filesystem::is_directory(path))
    throw InputError(
        fmt::format("cannot read {} '{}': {}", what, path.string(), errno ? std::strerror(errno) : "not a file"));
  return std::move(text).str();
}

}  // namespace nodal::elastic
