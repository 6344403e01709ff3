// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/same_height.h"

#include <filesystem>

#include <fmt/format.h>

namespace nodal::elastic {

void SameHeight::add(const std::optional<double>& z, const Source& source, const char* advice) {
  if (first_) {
    first_ = false;
    z_ = z;
  }
  if (z == z_) return;
  if (!z || !z_)
    throw InputError(source, "some points have a z and others don't; give x and y only, the system is plane");
  throw InputError(
      source, fmt::format("z is {} here and {} before: a plane system has one z; give x and y in its plane{}", *z, *z_,
                          advice));
}

std::string SameHeight::left_out(const std::string& file) const {
  return z_ ? fmt::format("{}: z, {} everywhere, is left out", std::filesystem::path(file).filename().string(), *z_)
            : std::string();
}

}  // namespace nodal::elastic
