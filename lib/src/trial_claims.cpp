// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial_claims.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
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

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool all_digits(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_digit); }

// Where a process has its number: "HOST-SPACE", as containers of one machine count their own.
std::string own_place() {
  char host[256] = "host", link[64] = "";
  ::gethostname(host, sizeof host - 1);
  (void)!::readlink("/proc/self/ns/pid", link, sizeof link - 1);  // "pid:[4026531836]"
  std::string space;
  for (const char c : std::string_view(link))
    if (is_digit(c)) space += c;
  return fmt::format("{}-{}", host, space.empty() ? "0" : space);
}

std::string own_name() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{}-{}-{}", own_place(), ::getpid(),
                     std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

// The parts of "HOST-SPACE-PROCESS-MOMENT".
struct Owner {
  std::string place;
  pid_t process = 0;
};

std::optional<Owner> parse_owner(std::string_view name) {
  std::array<std::string_view, 3> numbers;  // from the right
  for (std::string_view& number : numbers) {
    const std::size_t dash = name.rfind('-');
    if (dash == std::string_view::npos || !all_digits(number = name.substr(dash + 1))) return std::nullopt;
    name = name.substr(0, dash);
  }
  Owner owner{fmt::format("{}-{}", name, numbers[2])};
  std::from_chars(numbers[1].data(), numbers[1].data() + numbers[1].size(), owner.process);
  return owner;
}

// Of another place nobody knows.
bool is_known_dead(const Owner& owner) {
  static const std::string here = own_place();
  return owner.place == here && owner.process > 0 && ::kill(owner.process, 0) != 0 && errno == ESRCH;
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

// What claims leave behind, and nothing that somebody else has put there: OWNER.alive, OWNER.new, OWNER.stale,
// KEY.ATTEMPT, and what replace_file makes of these.
bool is_of_claims(const fs::path& file) {
  const std::string end = file.extension().string(), stem = file.stem().string();
  if (end == ".part") return is_of_claims(fs::path(stem).stem().stem());
  if (end == ".alive" || end == ".new" || end == ".stale") return parse_owner(stem).has_value();
  constexpr std::size_t kKeyDigits = 32;
  return end.size() > 1 && all_digits(std::string_view(end).substr(1)) && stem.size() == kKeyDigits &&
         stem.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::vector<fs::path> files_of_claims(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_of_claims(entry->path())) files.push_back(entry->path());
  return files;
}

}  // namespace

TrialClaims::TrialClaims(const fs::path& store, std::chrono::duration<double> patience)
    : folder_(store / "claims"), own_(own_name()), patience_(patience) {
  try {
    make_directory(folder_);
    make_alive();
    if (!others_live()) clear();
  } catch (const std::exception&) {
    own_.clear();
  }
}

TrialClaims::~TrialClaims() {
  if (own_.empty()) return;
  std::error_code ignored;
  for (const std::string& name : held_)
    if (content_of(folder_ / name) == own_) fs::remove(folder_ / name, ignored);
  if (last_ && !others_live()) clear();
  fs::remove(alive(own_), ignored);
  fs::remove(folder_, ignored);  // stays where it isn't empty
}

fs::path TrialClaims::alive(const std::string& owner) const { return folder_ / (owner + ".alive"); }

void TrialClaims::make_alive() {
  replace_file(alive(own_), "", Links::replace);
  touched_ = std::chrono::steady_clock::now();
}

bool TrialClaims::others_live() const {
  return std::ranges::any_of(files_of_claims(folder_), [this](const fs::path& file) {
    return file.extension() == ".alive" && file != alive(own_) && lives(file.stem().string());
  });
}

// All but this comparison's own sign of life.
void TrialClaims::clear() const {
  std::error_code ignored;
  for (const fs::path& file : files_of_claims(folder_))
    if (file != alive(own_)) fs::remove(file, ignored);
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
    if (lives(*owner) || !take_over(name, *owner)) return Answer::others;
  }
  return Answer::others;
}

// True also where there can be no claims: then everything is run.
bool TrialClaims::make(const std::string& name) {
  const Made made = make_with(folder_ / name, own_, folder_ / (own_ + ".new"));
  if (made == Made::yes) held_.insert(name);
  return made != Made::exists;
}

bool TrialClaims::lives(const std::string& owner) const {
  const std::optional<double> theirs = touched_at(alive(owner)), own = touched_at(alive(own_));
  if (!theirs || (own && *own - *theirs > patience_.count())) return false;
  const std::optional<Owner> parsed = parse_owner(owner);
  return !parsed || !is_known_dead(*parsed);
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
  touched_ = std::chrono::steady_clock::now();
  if (::utimensat(AT_FDCWD, alive(own_).c_str(), nullptr, 0) == 0) return;
  try {
    make_alive();
  } catch (const std::exception&) {  // others may take its claims over: their trials are stored twice then
  }
}

}  // namespace nodal
