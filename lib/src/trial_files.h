// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The files trials/*.jsonl of a store: one per writing process, append-only.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

/// A line that is no whole record: where it stands, the key of its trial where that can be read, and " (what is wrong)"
/// where it is more than cut off.
struct TornLine {
  std::string where, key, why;
};

struct StoredLines {
  std::vector<TrialRecord> records;  ///< in the order in which their files were begun, whatever copying did to times
  std::vector<TornLine> torn;
};

/// Of a store's directory; `each` record may be changed before the next is read. InputError for files that can't be
/// read; NewerSchemaError.
[[nodiscard]] StoredLines read_trial_files(const std::filesystem::path& store,
                                           const std::function<void(TrialRecord&)>& each = {});

/// The bytes of these files: they have grown when somebody has stored a trial since. Those without a size
/// count nothing: reading them says what is wrong.
[[nodiscard]] std::uintmax_t size_of_trial_files(const std::filesystem::path& store);

/// The file of this process. It is open only while a line is written, so that children never hold it.
class TrialFile {
 public:
  explicit TrialFile(std::filesystem::path store) : store_(std::move(store)) {}
  /// Written and flushed when this returns. A line that somebody left unfinished is ended first. StoreError; then the
  /// file is as it was.
  void append(const std::string& line);

 private:
  std::filesystem::path store_, path_;
};

}  // namespace nodal
