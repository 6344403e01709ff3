// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a trial's process sends its parent: the record as it is stored, and before it the same without what is
/// long, which is all that the parent reads. Parsing and writing ten thousand numbers takes as long as a short trial.

#include <string>
#include <string_view>

#include <nodal/record.h>

namespace nodal {

/// Takes out what is long, and what nobody needs before a record is read again: the trace, what was held out.
void shorten(TrialRecord& record);

/// One line, without the newline: the short record, a hash of the whole one's line, that line; tabs between, which JSON
/// escapes.
[[nodiscard]] std::string trial_message(const TrialRecord& record);

struct TrialMessage {
  TrialRecord record;  ///< short
  std::string line;    ///< of the whole one
};
/// InputError for one that was garbled on its way.
[[nodiscard]] TrialMessage read_trial_message(std::string_view message);

}  // namespace nodal
