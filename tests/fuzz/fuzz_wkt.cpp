// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines in WKT, and the check that makes bodies of them.
#include "fuzz_target.h"
#include "geometry/plane/outline_check.h"
#include "import/outline_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return nodal::fuzz::read(data, size, [](std::string_view text) {
    nodal::elastic::FileOutline outline = nodal::elastic::parse_wkt(text, "f.wkt");
    (void)nodal::elastic::plane::checked_body(std::move(outline.rings), "f", 1.0, 0.5, outline.source);
  });
}
