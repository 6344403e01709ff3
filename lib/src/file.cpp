// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/file.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "file_descriptor.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kOrdinaryMode = 0666;     // less what the umask takes
constexpr std::size_t kMostOfAPath = 300;  // in a message; names can be megabytes long

class Reading {
 public:
  Reading(const fs::path& path, std::string_view what)
      : path_(path), what_(what), descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (descriptor_ < 0) refuse(std::strerror(errno));
  }
  ~Reading() { ::close(descriptor_); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  std::string text(std::uintmax_t most) const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) refuse(std::strerror(errno));
    if (S_ISDIR(status.st_mode)) refuse(std::strerror(EISDIR));
    if (!S_ISREG(status.st_mode)) refuse("not a regular file; copy its content into one");
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    if (size > most) refuse_size(most);
    std::string text;
    text.reserve(size);
    char buffer[65536];
    for (;;) {
      const ssize_t got = ::read(descriptor_, buffer, sizeof buffer);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) refuse(std::strerror(errno));
      if (got == 0) return text;
      text.append(buffer, static_cast<std::size_t>(got));
      if (text.size() > most) refuse_size(most);  // files of /proc say that they are empty
    }
  }

 private:
  [[noreturn]] void refuse_size(std::uintmax_t most) const {
    refuse(fmt::format("it is larger than {:.0f} MB", static_cast<double>(most) / 1e6));
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("cannot read {}{}'{}': {}", what_, what_.empty() ? "" : " ",
                                 shown(path_.string(), kMostOfAPath), why));
  }

  const fs::path& path_;
  std::string_view what_;
  int descriptor_;
};

// Beside the file and renamed over it. It keeps the permissions of the file that it replaces. Processes of several
// machines or containers may have one number: digits by chance keep their files apart.
void write_beside_and_rename(const fs::path& path, const fs::path& shown, mode_t mode, std::string_view content) {
  std::random_device digits;
  const fs::path temporary = fmt::format("{}.{:08x}{:08x}.{}.part", path.string(), digits(), digits(), ::getpid());
  try {
    {
      FileDescriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, kOrdinaryMode, shown);
      if (mode != kOrdinaryMode) {
        [[maybe_unused]] const int ignored = ::fchmod(file.get(), mode);
      }
      file.write(content);
      file.flush();
    }
    if (::rename(temporary.c_str(), path.c_str()) != 0) refuse_write(shown, errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace

std::string read_file(const fs::path& path, std::string_view what, std::uintmax_t most) {
  return Reading(path, what).text(most);
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

namespace {

constexpr int kMostLinks = 40;  // as the system allows

// Where a name leads: through links, also where the last one's target is yet to be made.
fs::path target_of(const fs::path& path, std::error_code& error) {
  std::error_code none;
  if (fs::exists(path, none)) return fs::canonical(path, error);
  fs::path target = path;
  for (int links = 0; links < kMostLinks && fs::is_symlink(target, none); ++links)
    target = target.parent_path() / fs::read_symlink(target, none);
  if (fs::is_symlink(target, none)) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
  return target;
}

void replace_where_it_stands(const fs::path& path, std::string_view content) {
  struct stat status {};
  const bool there = ::lstat(path.c_str(), &status) == 0;
  if (there && !S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode))
    throw StoreError(fmt::format("cannot write '{}': it is no regular file; remove it", path.string()));
  write_beside_and_rename(path, path, there && S_ISREG(status.st_mode) ? status.st_mode & 07777 : kOrdinaryMode,
                          content);
}

// A pipe that nobody reads would be waited for without a word.
void write_into(const fs::path& path, std::string_view content) {
  FileDescriptor file(path, O_WRONLY | O_NONBLOCK, kOrdinaryMode, path);
  ::fcntl(file.get(), F_SETFL, 0);
  file.write(content);
}

}  // namespace

void replace_file(const fs::path& path, std::string_view content, Links links) {
  if (links == Links::replace) return replace_where_it_stands(path, content);
  struct stat status {};
  const bool there = ::stat(path.c_str(), &status) == 0;
  if (there && S_ISDIR(status.st_mode)) refuse_write(path, EISDIR);
  if (there && !S_ISREG(status.st_mode)) return write_into(path, content);
  std::error_code error;
  const fs::path target = target_of(path, error);
  if (error) refuse_write(path, error.value());
  write_beside_and_rename(target, path, there ? status.st_mode & 07777 : kOrdinaryMode, content);
}

std::string replace_refusal(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return "it is a folder";
  // Not by what its links lead to: an open pipe, /dev/fd/63, has no name.
  if (fs::exists(status) && !fs::is_regular_file(status))
    return ::access(path.c_str(), W_OK) == 0 ? "" : "it may not be written";
  error.clear();
  const fs::path target = target_of(path, error);
  if (error) return error.message();
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) return fmt::format("there is no folder '{}'", folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return fmt::format("the folder '{}' may not be written", folder.string());
  return {};
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {  // a terminal or pipe that another program has made non-blocking
      pollfd ready{descriptor, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace nodal
