// SPDX-License-Identifier: GPL-3.0-or-later
// Records of trials, as stores of others hold them; one that is read is written and read again.
#include <cstdlib>

#include <nodal/record.h>

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return nodal::fuzz::read(data, size, [](std::string_view text) {
    const nodal::TrialRecord record = nodal::parse_record(text, "trials.jsonl:1");
    const std::string written = nodal::to_json_line(record);
    if (nodal::to_json_line(nodal::parse_record(written, "again")) != written) std::abort();
  });
}
