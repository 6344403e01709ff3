// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "export/system_format.h"

namespace nodal::elastic {

extern const SystemFormat kSystemJson;  // system_export.cpp

Table<SystemFormat> system_formats() {
  static constexpr std::array kFormats = {
      &kSystemJson,
  };
  return kFormats;
}

}  // namespace nodal::elastic
