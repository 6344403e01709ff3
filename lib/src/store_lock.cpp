// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace nodal {

namespace {

// Bytes of the file that locks are put on; it needs no content for that.
constexpr off_t kWritersByte = 0;
constexpr off_t kManifestByte = 1;
constexpr int kMostTries = 100;  // 1 s

struct flock lock_on(off_t byte, int type) {
  struct flock lock {};
  lock.l_type = static_cast<short>(type);
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

// False when another process holds it; where there are no locks, nobody does.
bool set_lock(int descriptor, off_t byte, int type) noexcept {
  struct flock lock = lock_on(byte, type);
  return descriptor < 0 || ::fcntl(descriptor, F_SETLK, &lock) == 0 || (errno != EACCES && errno != EAGAIN);
}

}  // namespace

StoreLock::StoreLock(const std::filesystem::path& directory)
    : descriptor_(::open((directory / ".lock").c_str(), O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) {
    trouble_ = std::strerror(errno);
    return;
  }
  struct flock lock = lock_on(kWritersByte, F_RDLCK);
  if (::fcntl(descriptor_, F_SETLK, &lock) != 0 && errno != EACCES && errno != EAGAIN) trouble_ = std::strerror(errno);
}

StoreLock::~StoreLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<int> StoreLock::other_writer() const noexcept {
  struct flock lock = lock_on(kWritersByte, F_WRLCK);
  if (descriptor_ < 0 || ::fcntl(descriptor_, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return std::nullopt;
  return static_cast<int>(lock.l_pid);
}

void StoreLock::release() noexcept { set_lock(descriptor_, kWritersByte, F_UNLCK); }

// Whoever holds it for longer was stopped in the middle; its manifest is whole, as that is replaced at once.
StoreLock::Alone::Alone(const StoreLock& lock) noexcept : lock_(lock) {
  for (int tries = 0; tries < kMostTries && !set_lock(lock_.descriptor_, kManifestByte, F_WRLCK); ++tries)
    ::usleep(10000);
}

StoreLock::Alone::~Alone() { set_lock(lock_.descriptor_, kManifestByte, F_UNLCK); }

}  // namespace nodal
