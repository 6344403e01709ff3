// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/store.h>

#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/provenance.h>

#include "file_descriptor.h"
#include "leftovers.h"
#include "manifest.h"
#include "origins.h"
#include "require_manifest.h"
#include "store_lock.h"
#include "trial_files.h"
#include "trial_message.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "manifest.json";

Value read_manifest(const fs::path& path) {
  if (!fs::exists(path)) return {};
  Value manifest = parse_json(read_file(path, ""), path.string());
  require_manifest(manifest, path.string());
  return manifest;
}

// A folder of a store that is a link leads out of it: files written there would replace those of somebody else. (The
// store itself may be one: whoever named it meant it.)
void refuse_link(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(folder, ignored)))
    throw StoreError(fmt::format("cannot write into '{}': it is a link; remove it", folder.string()));
}

}  // namespace

struct Store::State {
  fs::path directory;
  Value manifest;
  std::vector<TrialRecord> records;
  std::unordered_map<std::string, std::size_t> by_key;
  std::vector<std::string> warnings;
  TrialFile file;
  std::uintmax_t size_read = 0;                     // of the files of trials
  std::unique_ptr<StoreLock> lock;                  // since `begin`
  std::optional<std::pair<dev_t, ino_t>> identity;  // of the directory, since `begin`
  InMemory in_memory;

  explicit State(fs::path path, InMemory memory = InMemory::whole)
      : directory(std::move(path)), file(directory), in_memory(memory) {
    read();
  }

  void read() {
    try {
      manifest = read_manifest(directory / kManifest);
      size_read = size_of_trial_files(directory);
      records.clear();
      by_key.clear();
      warnings.clear();
      StoredLines lines = read_trial_files(directory, [this](TrialRecord& record) { shorten(record); });
      for (TrialRecord& record : lines.records) add(std::move(record));
      for (const TornLine& line : lines.torn) warn_of_torn(line);
    } catch (const fs::filesystem_error& error) {
      throw InputError(fmt::format("cannot read '{}': {}", error.path1().string(), error.code().message()));
    }
  }

  void shorten(TrialRecord& record) const {
    if (in_memory == InMemory::short_records) nodal::shorten(record);
  }

  // Of two with one key the later attempt counts; of two with one attempt, which two comparisons at once may leave, the
  // one whose file was begun first.
  void add(TrialRecord record) {
    const auto [entry, is_new] = by_key.emplace(record.key, records.size());
    if (is_new)
      records.push_back(std::move(record));
    else if (record.attempt > records[entry->second].attempt)
      records[entry->second] = std::move(record);
  }

  // Its trial has run since then? A line without a readable key may have been any trial's, as long as one is missing.
  void warn_of_torn(const TornLine& line) {
    if (line.key.empty() ? has_all() : by_key.contains(line.key)) return;
    warnings.push_back(fmt::format("{}: a line that is no whole record was dropped{}; its trial counts as not run",
                                   line.where, line.why));
  }

  bool has_all() const {
    const Value* keys = manifest.is_table() ? manifest.find("keys") : nullptr;
    if (!keys || !keys->is_list()) return false;
    return std::ranges::all_of(keys->list(),
                               [this](const Value& key) { return key.is_text() && by_key.contains(key.text()); });
  }

  void warn_of_origins(const Value& here, const std::string& whose) {
    for (std::string& warning : origin_warnings(directory.string(), manifest, records, here, whose))
      warnings.push_back(std::move(warning));
  }

  // From now on others see this process; what they stored before that, and may have cleared their claims of, is read.
  void take_lock() {
    lock.reset();  // first: closing a lock's file gives up every lock that a process has on it
    lock = std::make_unique<StoreLock>(directory);
    if (size_of_trial_files(directory) != size_read) read();
    if (const std::string why = lock->trouble(); !why.empty())
      warnings.push_back(fmt::format("'{}' can't be locked ({}): another comparison that writes here goes unnoticed",
                                     (directory / ".lock").string(), why));
  }

  std::optional<std::pair<dev_t, ino_t>> present_identity() const {
    struct stat status {};
    if (::stat(directory.c_str(), &status) != 0 || !fs::exists(directory / kManifest)) return std::nullopt;
    return std::pair(status.st_dev, status.st_ino);
  }

  // A file that is open can be written long after its directory has gone.
  void require_in_place() const {
    if (!identity || present_identity() == identity) return;
    throw StoreError(fmt::format("the store '{}' was moved or removed while trials ran; what it held is where it went",
                                 directory.string()));
  }
};

Store::Store(std::filesystem::path directory, InMemory in_memory)
    : state_(std::make_unique<State>(std::move(directory), in_memory)) {
  make_directory(state_->directory);
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}

Store Store::open_existing(const std::filesystem::path& directory) {
  if (!fs::exists(directory / kManifest))
    throw InputError(fmt::format("'{}' is not a store: it has no {}; give the directory that nodal compare wrote",
                                 directory.string(), kManifest));
  Store store(std::make_unique<State>(directory));
  if (const Value last = last_provenance(store.manifest()); !last.table().empty())
    store.state_->warn_of_origins(last, "last run's");
  return store;
}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

const std::filesystem::path& Store::directory() const noexcept { return state_->directory; }
const std::vector<std::string>& Store::warnings() const noexcept { return state_->warnings; }
const std::vector<TrialRecord>& Store::records() const noexcept { return state_->records; }
const Value& Store::manifest() const noexcept { return state_->manifest; }

const TrialRecord* Store::find(std::string_view key) const {
  const auto found = state_->by_key.find(std::string(key));
  return found == state_->by_key.end() ? nullptr : &state_->records[found->second];
}

void Store::begin(const Study& study) {
  State& state = *state_;
  const fs::path path = state.directory / kManifest;
  const Value here = provenance();
  for (const char* folder : {"trials", "claims"}) refuse_link(state.directory / folder);
  refuse_link(cache_of(state.directory));
  state.take_lock();
  if (const std::string other = other_study(state.manifest, study); !other.empty())
    state.warnings.push_back(fmt::format("'{}' {}: the report will show this one only; --out DIR keeps them apart",
                                         state.directory.string(), other));
  remove_leftovers(state.directory);
  const StoreLock::Alone alone(*state.lock);
  Value manifest = make_manifest(study, read_manifest(path), here);  // read again: others may have begun since
  replace_file(path, to_json(manifest) + "\n", Links::replace);
  state.manifest = std::move(manifest);
  state.identity = state.present_identity();
  state.warn_of_origins(here, "present one");
}

InMemory Store::in_memory() const noexcept { return state_->in_memory; }

void Store::append(const TrialRecord& record) { append(record, to_json_line(record)); }

void Store::append(const TrialRecord& record, const std::string& line) {
  state_->require_in_place();
  state_->file.append(line);
  TrialRecord kept = record;
  state_->shorten(kept);
  state_->add(std::move(kept));
}

void Store::leave() noexcept {
  if (state_->lock) state_->lock->release();
}

std::optional<int> Store::other_writer() const noexcept {
  return state_->lock ? state_->lock->other_writer() : std::nullopt;
}

void Store::write_file(const std::string& name, std::string_view content) {
  state_->require_in_place();
  const fs::path path = state_->directory / name;
  if (fs::path(name).has_parent_path()) refuse_link(path.parent_path());
  make_directory(path.parent_path());
  replace_file(path, content, Links::replace);
}

}  // namespace nodal
