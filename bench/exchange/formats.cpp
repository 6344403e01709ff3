// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "format.h"

namespace nodal::exchange {

std::span<const Format> formats() {
  static constexpr std::array<Format, 2> all = {{
      {"coco", "COCO's .info, .dat and .tdat, for cocopp, IOHanalyzer and IOHinspector", write_coco},
      {"ioh", "IOHprofiler's .json and .dat, with seconds, for IOHanalyzer and IOHinspector", write_ioh},
  }};
  return all;
}

}  // namespace nodal::exchange
