// SPDX-License-Identifier: GPL-3.0-or-later
#include "store_lock.h"

#include <fcntl.h>
#include <unistd.h>

namespace nodal {

namespace {

// Bytes of the file that locks are put on; it needs no content for that.
constexpr off_t kWriters = 0;
constexpr off_t kManifest = 1;

struct flock lock_on(off_t byte, int type) {
  struct flock lock {};
  lock.l_type = static_cast<short>(type);
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

void set(int descriptor, int command, off_t byte, int type) noexcept {
  if (descriptor < 0) return;
  struct flock lock = lock_on(byte, type);
  ::fcntl(descriptor, command, &lock);
}

}  // namespace

StoreLock::StoreLock(const std::filesystem::path& directory)
    : descriptor_(::open((directory / ".lock").c_str(), O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666)) {
  set(descriptor_, F_SETLK, kWriters, F_RDLCK);
}

StoreLock::~StoreLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<int> StoreLock::other_writer() const noexcept {
  struct flock lock = lock_on(kWriters, F_WRLCK);
  if (descriptor_ < 0 || ::fcntl(descriptor_, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return std::nullopt;
  return static_cast<int>(lock.l_pid);
}

StoreLock::Alone::Alone(const StoreLock& lock) noexcept : lock_(lock) {
  set(lock_.descriptor_, F_SETLKW, kManifest, F_WRLCK);
}

StoreLock::Alone::~Alone() { set(lock_.descriptor_, F_SETLK, kManifest, F_UNLCK); }

}  // namespace nodal
