// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <tuple>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/shown.h>

#include "file_descriptor.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostOfAnError = 200;

constexpr const char* kFolder = "trials";
constexpr std::uintmax_t kLargestTrialsFile = std::uintmax_t{1} << 34;  // 16 GB: a record is a few kB

// One file per writing process: host, process and moment [ms] name it.
std::string writer_name() {
  char host[256] = "host";
  ::gethostname(host, sizeof host - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{}-{}-{}.jsonl", host, ::getpid(),
                     std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

// The moment in a file's name; 0 for a name of another kind.
std::int64_t moment_of(const fs::path& file) {
  const std::string name = file.stem().string();
  const std::size_t dash = name.rfind('-');
  std::int64_t moment = 0;
  if (dash != std::string::npos) std::from_chars(name.data() + dash + 1, name.data() + name.size(), moment);
  return moment;
}

std::vector<fs::path> files_in_order(const fs::path& store) {
  std::vector<fs::path> files;
  if (fs::is_directory(store / kFolder))
    for (const fs::directory_entry& entry : fs::directory_iterator(store / kFolder))
      if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::ranges::sort(files, {}, [](const fs::path& file) { return std::tuple(moment_of(file), file); });
  return files;
}

// What still can be read of a line that was cut off: the key stands near its beginning.
std::string key_in(std::string_view line) {
  constexpr std::string_view kBefore = R"("key":")";
  constexpr std::size_t kDigits = 32;
  const std::size_t at = line.find(kBefore);
  if (at == std::string_view::npos) return {};
  const std::string_view key = line.substr(at + kBefore.size(), kDigits);
  const bool whole = key.size() == kDigits && key.find_first_not_of("0123456789abcdef") == std::string_view::npos;
  return whole ? std::string(key) : std::string();
}

using Each = std::function<void(TrialRecord&)>;

void read_line(const std::string& where, std::string_view line, const Each& each, StoredLines& result) {
  try {
    TrialRecord& record = result.records.emplace_back(parse_record(line, where));
    if (each) each(record);
  } catch (const NewerSchemaError&) {
    throw;
  } catch (const InputError& error) {
    const std::string_view what = error.what();
    const bool cut_off = what.find("not valid JSON") != std::string_view::npos;
    // After "where: ", or "where:1: " with the line within the record.
    const std::size_t colon = what.starts_with(where) ? what.find(": ", where.size()) : std::string_view::npos;
    const std::string_view reason = what.substr(colon == std::string_view::npos ? 0 : colon + 2);
    result.torn.push_back({where, key_in(line), cut_off ? "" : fmt::format(" ({})", shown(reason, kMostOfAnError))});
  }
}

}  // namespace

StoredLines read_trial_files(const fs::path& store, const Each& each) {
  StoredLines result;
  for (const fs::path& file : files_in_order(store)) {
    const std::string text = read_file(file, "", kLargestTrialsFile);
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      ++number;
      const std::string_view line = std::string_view(text).substr(begin, end - begin);
      if (!line.empty()) read_line(fmt::format("{}:{}", file.string(), number), line, each, result);
      begin = end + 1;
    }
  }
  return result;
}

std::uintmax_t size_of_trial_files(const fs::path& store) {
  std::uintmax_t sum = 0;
  for (const fs::path& file : files_in_order(store)) {
    std::error_code error;
    if (const std::uintmax_t size = fs::file_size(file, error); !error) sum += size;
  }
  return sum;
}

void TrialFile::append(const std::string& line) {
  const bool first = path_.empty();
  const fs::path path = first ? store_ / kFolder / writer_name() : path_;
  if (first) make_directory(store_ / kFolder);
  // Only the first line makes the file: should it be gone later, so are its lines, and that must be noticed.
  if (!first && !fs::exists(path))
    throw StoreError(
        fmt::format("'{}' was removed while trials ran, and with it what they had stored there; run the "
                    "comparison again: it runs what the store lacks",
                    path.string()));
  FileDescriptor file(path, O_RDWR | O_APPEND | (first ? O_CREAT : 0), 0666, path);
  path_ = path;
  const off_t before = file.size();
  try {
    file.write((file.ends_a_line() ? "" : "\n") + line + "\n");
    file.flush();
  } catch (const StoreError&) {
    file.cut_to(before);
    throw;
  }
}

}  // namespace nodal
