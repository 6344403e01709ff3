// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "export/system_format.h"

namespace nodal::elastic {

extern const SystemFormat kSystemJson;

Table<SystemFormat> system_formats() {
  static constexpr std::array kFormats = {
      &kSystemJson,  // system_export.cpp
  };
  return kFormats;
}

}  // namespace nodal::elastic
