// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/file.h>

namespace nodal {

namespace fs = std::filesystem;

void refuse_write(const fs::path& path, int error) {
  throw StoreError(
      fmt::format("cannot write '{}': {}; what was stored before stays valid", path.string(), std::strerror(error)));
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) refuse_write(path, error.value());
}

FileDescriptor::FileDescriptor(const fs::path& path, int flags, mode_t mode, fs::path shown)
    : shown_(std::move(shown)), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {
  if (descriptor_ < 0) refuse_write(shown_, errno);
}

FileDescriptor::~FileDescriptor() { ::close(descriptor_); }

void FileDescriptor::write(std::string_view text) {
  if (const int error = write_all(descriptor_, text); error != 0) refuse_write(shown_, error);
}

void FileDescriptor::flush() {
  // Some file systems can't; a full disk shows itself here at the latest.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) refuse_write(shown_, errno);
}

off_t FileDescriptor::size() const noexcept {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 ? status.st_size : 0;
}

bool FileDescriptor::ends_a_line() const noexcept {
  char last = '\n';
  const off_t length = size();
  return length == 0 || ::pread(descriptor_, &last, 1, length - 1) != 1 || last == '\n';
}

void FileDescriptor::cut_to(off_t size) noexcept {
  [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, size);
}

}  // namespace nodal
