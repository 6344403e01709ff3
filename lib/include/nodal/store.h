// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A study's directory: manifest.json, trials/*.jsonl (one file per writing process, append-only), report.html,
/// summary.csv.
///
/// Crash-safe: a record is one line, written by one call; a line that was cut off or garbled is dropped, with a warning
/// until its trial has run again. Nothing stored is ever overwritten: a trial that is run again adds a record with a
/// later `attempt`, and the latest counts.
///
/// Errors   StoreError when a file can't be made or written (folder, reason), or the directory was moved or removed
///          after `begin`. InputError for a store of a newer schema or a manifest that can't be read.
/// Threads  one object per process, one thread.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/record.h>
#include <nodal/study.h>

namespace nodal {

/// What a store keeps of its records in memory: all, or what `compare` asks for, without what is long (traces, points,
/// what was held out), which is in the files. A process that forks for every trial copies its page tables each time.
enum class InMemory { whole, short_records };

class Store {
 public:
  /// Opens a store for reading and, with the first `append`, for writing. The directory is made when it isn't there.
  explicit Store(std::filesystem::path directory, InMemory in_memory = InMemory::whole);
  /// Opens a store that must exist, for reading; nothing is created.
  [[nodiscard]] static Store open_existing(const std::filesystem::path& directory);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  [[nodiscard]] const std::filesystem::path& directory() const noexcept;
  /// Where a store keeps what takes long to make (result_cache.h).
  [[nodiscard]] static std::filesystem::path cache_of(const std::filesystem::path& directory) {
    return directory / "cache";
  }
  /// Dropped lines, another study, trials of other builds or processors (than this one after `begin`, than the last
  /// run's in a store opened for reading), for people.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept;
  [[nodiscard]] InMemory in_memory() const noexcept;
  /// Every valid record, oldest first; of several with one key that of the latest attempt. As much of each as is kept.
  [[nodiscard]] const std::vector<TrialRecord>& records() const noexcept;
  [[nodiscard]] const TrialRecord* find(std::string_view key) const;

  /// Writes the study into the manifest (atomically), with this build's provenance and the keys of its trials, before
  /// the first trial runs. Removes what writers that died have left half-written. Warns when results of another build,
  /// processor or study are here. What others have stored since this object was made is read, too.
  void begin(const Study& study);
  /// Stores one record: written and flushed to the system when this returns.
  void append(const TrialRecord& record);
  /// The same of a record that is written already; only `line` is what is stored.
  void append(const TrialRecord& record, const std::string& line);
  /// After the last `append`: this process no longer writes here. Of several that leave at once the last sees nobody.
  void leave() noexcept;
  /// After `begin`: the process of another comparison that writes here now.
  [[nodiscard]] std::optional<int> other_writer() const noexcept;

  /// The manifest as it stands: {schema, study: {name, file, directory, seed, repeats, text}, problems: [{label, kind,
  /// options, inputs, best_known: {quality, origin, x}, details}], optimizers: [{label, use, baseline, multi_start,
  /// deterministic, options}], left_out: [{label, use, reason}], keys: [the current study's trials], runs: [{began,
  /// build, provenance}]}; inputs, best_known, its x and details where there are any, and options but in old ones. But
  /// for the runs, whatever is there is of its right type. Empty table for a new store.
  [[nodiscard]] const Value& manifest() const noexcept;

  /// Writes a file of the store (report.html, …) atomically.
  void write_file(const std::string& name, std::string_view content);

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace nodal
