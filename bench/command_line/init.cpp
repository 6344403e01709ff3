// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/file.h>

#include "commands.h"
#include "editing/study_template.h"
#include "output_file.h"

namespace nodal {

int init_command(const InitArguments& arguments, const Registry& registry) {
  const std::string& file = arguments.file;
  std::error_code error;
  if (!file.empty() && std::filesystem::exists(std::filesystem::symlink_status(file, error)))
    throw InputError(fmt::format("'{}' is there already, and is left as it is; give a new name", file));
  if (!file.empty()) refuse_unwritable("FILE", file);
  const std::string text = editing::study_template({arguments.problem, arguments.optimizers}, registry);
  if (file.empty()) {
    std::cout << text;
    return 0;
  }
  replace_file(file, text);
  std::cerr << fmt::format("study: {}\n", file);
  return 0;
}

}  // namespace nodal
