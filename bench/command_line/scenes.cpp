// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes.h"

#include <system_error>

namespace nodal {

namespace fs = std::filesystem;

fs::path scenes_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "nodal" / "scenes";
  if (!error && fs::is_directory(installed)) return installed;
  return NODAL_SCENES;
}

}  // namespace nodal
