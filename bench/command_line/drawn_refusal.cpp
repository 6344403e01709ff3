// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_refusal.h"

#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/file.h>

#include "output_file.h"

namespace nodal {

Study read_study_or_draw(const std::string& path, const Registry& registry, const StudyOverrides& overrides,
                         const std::string& picture) {
  StudyOverrides own = overrides;
  own.without_best_known_files = true;
  try {
    return read_study(path, registry, own);
  } catch (const DrawnInputError& error) {
    if (!picture.empty()) {
      refuse_no_picture("--picture", picture);
      replace_file(picture, error.picture(std::filesystem::path(path).stem().string()));
      std::cerr << fmt::format("written: {}\n", picture);
    }
    throw;
  }
}

}  // namespace nodal
