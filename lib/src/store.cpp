// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/store.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <unordered_map>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/provenance.h>
#include <nodal/trial.h>

#include "file_descriptor.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr int kManifestSchema = 1;
constexpr const char* kManifest = "manifest.json";
constexpr std::uintmax_t kLargestTrialsFile = std::uintmax_t{1} << 34;  // 16 GB: a record is a few kB

[[noreturn]] void refuse_read(const fs::path& path, int error) {
  throw InputError(fmt::format("cannot read '{}': {}", path.string(), std::strerror(error)));
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) refuse_write(path, error.value());
}

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

// One file per writing process: host, process and moment name it.
std::string writer_name() {
  char host[256] = "host";
  ::gethostname(host, sizeof host - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{}-{}-{}.jsonl", host, ::getpid(),
                     std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

Value study_part(const Study& study) {
  Value part;
  part.set("name", study.name);
  part.set("file", study.path.string());
  std::error_code ignored;
  part.set("directory",
           fs::absolute(study.path.parent_path().empty() ? "." : study.path.parent_path(), ignored).string());
  part.set("seed", Value(study.seed));
  part.set("repeats", study.repeats);
  part.set("text", study.text);
  return part;
}

Value problem_part(const StudyProblem& problem) {
  Value part;
  part.set("label", problem.label);
  part.set("kind", problem.kind);
  part.set("options", problem.options.values());
  if (problem.best_known) {
    Value known;
    known.set("quality", problem.best_known->quality);
    known.set("origin", problem.best_known->origin);
    part.set("best_known", known);
  }
  if (Value details = problem.problem->details(); !details.table().empty()) part.set("details", std::move(details));
  return part;
}

Value optimizer_part(const StudyOptimizer& optimizer) {
  Value part;
  part.set("label", optimizer.label);
  part.set("use", optimizer.use);
  part.set("baseline", optimizer.baseline);
  part.set("multi_start", optimizer.multi_start);
  return part;
}

Value left_out_part(const LeftOut& left_out) {
  Value part;
  part.set("label", left_out.label);
  part.set("use", left_out.use);
  part.set("reason", left_out.reason);
  return part;
}

template <class Items, class Part>
Value list_of(const Items& items, Part part) {
  Value::List list;
  for (const auto& item : items) list.push_back(part(item));
  return Value(std::move(list));
}

// Of the whole study, whatever a command leaves out this time: a report shows all that is stored of it.
Value keys_part(Study study) {
  for (StudyOptimizer& optimizer : study.optimizers) optimizer.skipped = false;
  return list_of(all_trials(study), [&](const Trial& trial) { return Value(trial_key(study, trial)); });
}

}  // namespace

struct Store::State {
  fs::path directory;
  Value manifest;
  std::vector<TrialRecord> records;
  std::unordered_map<std::string, std::size_t> by_key;
  std::vector<std::string> warnings;
  std::unique_ptr<FileDescriptor> out;

  explicit State(fs::path path) : directory(std::move(path)) {
    try {
      read_manifest();
      read_records();
    } catch (const fs::filesystem_error& error) {
      refuse_read(error.path1(), error.code().value());
    }
  }

  void read_manifest() {
    const fs::path path = directory / kManifest;
    if (!fs::exists(path)) return;
    manifest = parse_json(read_file(path, ""), path.string());
    const Value* schema = manifest.is_table() ? manifest.find("schema") : nullptr;
    if (!schema || !schema->is_integer())
      throw InputError(fmt::format("'{}' is not the manifest of a store: it has no schema; choose another directory",
                                   path.string()));
    if (schema->integer() > kManifestSchema)
      throw NewerSchemaError(
          fmt::format("'{}' has schema {}, this build reads up to {}; use a newer nodal or another "
                      "directory",
                      path.string(), schema->integer(), kManifestSchema));
  }

  void read_records() {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;  // another process may be writing: times are asked once
    if (fs::is_directory(directory / "trials"))
      for (const fs::directory_entry& entry : fs::directory_iterator(directory / "trials"))
        if (entry.path().extension() == ".jsonl") files.emplace_back(fs::last_write_time(entry.path()), entry.path());
    std::ranges::sort(files);
    for (const auto& [time, file] : files) read_lines(file);
  }

  void read_lines(const fs::path& file) {
    const std::string text = read_file(file, "", kLargestTrialsFile);
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      ++number;
      if (end > begin) read_line(file, number, std::string_view(text).substr(begin, end - begin));
      begin = end + 1;
    }
  }

  void read_line(const fs::path& file, int number, std::string_view line) {
    const std::string where = fmt::format("{}:{}", file.string(), number);
    try {
      add(parse_record(line, where));
    } catch (const NewerSchemaError&) {
      throw;
    } catch (const InputError&) {
      warnings.push_back(where + ": a line that is no whole record was dropped; its trial runs again");
    }
  }

  void add(TrialRecord record) {
    if (by_key.emplace(record.key, records.size()).second) records.push_back(std::move(record));
  }

  void warn_of_other_builds(const Value& here) {
    const Value* runs = manifest.find("runs");
    if (!runs || !runs->is_list() || records.empty()) return;
    for (const Value& run : runs->list()) {
      const Value* other = run.is_table() ? run.find("provenance") : nullptr;
      if (!other || !other->is_table() || build_identity(*other) == build_identity(here)) continue;
      const Value* said = other->find("revision");
      warnings.push_back(
          fmt::format("'{}' holds results of another build (revision {}; this is {}): times don't compare",
                      directory.string(), said && said->is_text() ? said->text() : "unknown", revision()));
      return;
    }
  }
};

Store::Store(std::filesystem::path directory) : state_(std::make_unique<State>(std::move(directory))) {
  make_directory(state_->directory);
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}

Store Store::open_existing(const std::filesystem::path& directory) {
  if (!fs::exists(directory / kManifest))
    throw InputError(fmt::format("'{}' is not a store: it has no {}; give the directory that nodal compare wrote",
                                 directory.string(), kManifest));
  return Store(std::make_unique<State>(directory));
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
  const Value here = provenance();
  state_->warn_of_other_builds(here);
  Value run;
  run.set("began", utc_now());
  run.set("provenance", here);
  Value::List runs;
  if (const Value* before = state_->manifest.find("runs"); before && before->is_list()) runs = before->list();
  runs.push_back(run);

  Value manifest;
  manifest.set("schema", kManifestSchema);
  manifest.set("study", study_part(study));
  manifest.set("problems", list_of(study.problems, problem_part));
  manifest.set("optimizers", list_of(study.optimizers, optimizer_part));
  manifest.set("left_out", list_of(study.left_out, left_out_part));
  manifest.set("keys", keys_part(study));
  manifest.set("runs", Value(std::move(runs)));
  replace_file(state_->directory / kManifest, to_json(manifest) + "\n");
  state_->manifest = std::move(manifest);
}

void Store::append(const TrialRecord& record) {
  if (!state_->out) {
    make_directory(state_->directory / "trials");
    const fs::path path = state_->directory / "trials" / writer_name();
    state_->out = std::make_unique<FileDescriptor>(path, O_WRONLY | O_CREAT | O_APPEND, 0666, path);
  }
  const off_t before = state_->out->size();
  try {
    state_->out->write(to_json_line(record) + "\n");
    state_->out->flush();
  } catch (const StoreError&) {
    state_->out->cut_to(before);
    throw;
  }
  state_->add(record);
}

void Store::write_file(const std::string& name, std::string_view content) {
  const fs::path path = state_->directory / name;
  make_directory(path.parent_path());
  replace_file(path, content);
}

}  // namespace nodal
