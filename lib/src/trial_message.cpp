// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_message.h"

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/random.h>

namespace nodal {

namespace {

constexpr const char* kName = "trial";
constexpr std::size_t kHashDigits = 16;

std::string line_hash(std::string_view line) { return fmt::format("{:016x}", hash64(line)); }

}  // namespace

void shorten(TrialRecord& record) {
  record.trace = {};
  record.unseen.reset();
}

std::string trial_message(const TrialRecord& record) {
  const std::string line = to_json_line(record);
  TrialRecord brief = record;
  shorten(brief);
  return to_json_line(brief) + "\t" + line_hash(line) + "\t" + line;
}

TrialMessage read_trial_message(std::string_view message) {
  const std::size_t first = message.find('\t');
  TrialMessage result{parse_record(message.substr(0, first), kName), {}};
  const std::string_view rest = first == std::string_view::npos ? std::string_view() : message.substr(first + 1);
  if (rest.size() > kHashDigits + 1 && rest[kHashDigits] == '\t') result.line = rest.substr(kHashDigits + 1);
  if (result.line.empty() || rest.substr(0, kHashDigits) != line_hash(result.line))
    throw InputError(std::string(kName) + ": it was garbled on its way");
  return result;
}

}  // namespace nodal
