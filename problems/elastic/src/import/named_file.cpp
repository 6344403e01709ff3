// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/named_file.h"

#include <system_error>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

namespace nodal::elastic {

std::filesystem::path named_file(const InputFiles& files, const Value& option) {
  std::filesystem::path path = files.path(option.text());
  std::error_code unknown;  // what can't be looked at is read, and then it is said why not
  if (std::filesystem::status(path, unknown).type() == std::filesystem::file_type::not_found)
    throw InputError(option.source, fmt::format("cannot read '{}': No such file or directory", shown(path.string())));
  return path;
}

}  // namespace nodal::elastic
