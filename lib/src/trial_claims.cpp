// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_claims.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <nodal/file.h>

#include "file_descriptor.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kBeat{2};
constexpr std::string_view kDone = "done";

std::string own_name() {
  char host[256] = "host";
  ::gethostname(host, sizeof host - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{}-{}-{}", host, ::getpid(), std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

std::string file_name(const std::string& key, std::int64_t attempt) { return fmt::format("{}.{}", key, attempt); }

enum class Made { yes, exists, impossible };

// The file appears with its content: a reader never sees an empty one. link() fails where the name is taken, on network
// file systems, too.
Made make_with(const fs::path& file, std::string_view content, const fs::path& scratch) {
  std::error_code error;
  try {
    replace_file(scratch, content, Links::replace);
  } catch (const std::exception&) {
    return Made::impossible;
  }
  const int failed = ::link(scratch.c_str(), file.c_str()) == 0 ? 0 : errno;
  fs::remove(scratch, error);
  return failed == 0 ? Made::yes : failed == EEXIST ? Made::exists : Made::impossible;
}

std::optional<std::string> content_of(const fs::path& file) {
  try {
    return read_file(file, "");
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<double> touched_at(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

// What claims leave behind, and nothing that somebody else has put there.
bool is_of_claims(const fs::path& file) {
  const std::string end = file.extension().string(), key = file.stem().string();
  if (end == ".alive" || end == ".new" || end == ".stale" || end == ".part") return true;
  constexpr std::size_t kKeyDigits = 32;
  const bool numbered = end.size() > 1 && end.find_first_not_of("0123456789", 1) == std::string::npos;
  return numbered && key.size() == kKeyDigits && key.find_first_not_of("0123456789abcdef") == std::string::npos;
}

void clear(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
    if (is_of_claims(entry->path())) files.push_back(entry->path());
  for (const fs::path& file : files) fs::remove(file, ignored);
  fs::remove(folder, ignored);  // stays where it isn't empty
}

}  // namespace

TrialClaims::TrialClaims(const fs::path& store, bool alone, std::chrono::duration<double> patience)
    : folder_(store / "claims"), own_(own_name()), patience_(patience) {
  if (alone) clear(folder_);
  try {
    make_directory(folder_);
    replace_file(folder_ / (own_ + ".alive"), "", Links::replace);
    touched_ = std::chrono::steady_clock::now();
  } catch (const std::exception&) {
    own_.clear();
  }
}

TrialClaims::~TrialClaims() {
  if (own_.empty()) return;
  if (last_) {
    clear(folder_);
    return;
  }
  std::error_code ignored;
  for (const std::string& name : held_)
    if (content_of(folder_ / name) == own_) fs::remove(folder_ / name, ignored);
  fs::remove(folder_ / (own_ + ".alive"), ignored);
}

TrialClaims::Answer TrialClaims::claim(const std::string& key, std::int64_t attempt) {
  if (own_.empty()) return Answer::granted;
  const std::string name = file_name(key, attempt);
  if (held_.contains(name)) return Answer::granted;  // it runs again
  constexpr int kTries = 3;                          // a claim may be given back between two looks
  for (int i = 0; i < kTries; ++i) {
    if (make(name)) return Answer::granted;
    const std::optional<std::string> owner = content_of(folder_ / name);
    if (!owner) continue;
    if (*owner == kDone) return Answer::done;
    if (!stale(*owner) || !take_over(name, *owner)) return Answer::others;
  }
  return Answer::others;
}

// True also where there can be no claims: then everything is run.
bool TrialClaims::make(const std::string& name) {
  const Made made = make_with(folder_ / name, own_, folder_ / (own_ + ".new"));
  if (made == Made::yes) held_.insert(name);
  return made != Made::exists;
}

bool TrialClaims::stale(const std::string& owner) const {
  const std::optional<double> theirs = touched_at(folder_ / (owner + ".alive"));
  if (!theirs) return true;
  const std::optional<double> own = touched_at(folder_ / (own_ + ".alive"));
  return own && *own - *theirs > patience_.count();
}

// Of several who see the same stale claim one moves it away. Who moves a new one by mistake, made since it looked, puts
// it back.
bool TrialClaims::take_over(const std::string& name, const std::string& owner) {
  const fs::path file = folder_ / name, away = folder_ / (own_ + ".stale");
  if (::rename(file.c_str(), away.c_str()) != 0) return true;  // somebody else has: look again
  const bool as_seen = content_of(away) == owner;
  if (!as_seen) (void)::link(away.c_str(), file.c_str());
  std::error_code ignored;
  fs::remove(away, ignored);
  return as_seen;
}

void TrialClaims::done(const std::string& key, std::int64_t attempt) {
  const std::string name = file_name(key, attempt);
  if (held_.erase(name) == 0) return;
  try {
    replace_file(folder_ / name, kDone, Links::replace);
  } catch (const std::exception&) {  // somebody may run it again: it is stored twice then
  }
}

void TrialClaims::beat() {
  if (own_.empty() || std::chrono::steady_clock::now() - touched_ < kBeat) return;
  (void)::utimensat(AT_FDCWD, (folder_ / (own_ + ".alive")).c_str(), nullptr, 0);
  touched_ = std::chrono::steady_clock::now();
}

}  // namespace nodal
