// SPDX-License-Identifier: GPL-3.0-or-later
// System and stiffness files in JSON; what is read of them is written and read again.
#include <cstdlib>

#include <nodal/value.h>

#include "fuzz_target.h"
#include "import/system_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return nodal::fuzz::read(data, size, [](std::string_view text) {
    const nodal::Value value = nodal::parse_json(text, "f.json");
    const std::string written = nodal::to_json(value);
    if (nodal::to_json(nodal::parse_json(written, "again.json")) != written) std::abort();
    (void)nodal::elastic::parse_system_json(text, "f.json");
  });
}
