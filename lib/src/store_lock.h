// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Who else writes to a store: every comparison holds a shared lock on the store's file `.lock` while it lives, and
/// asks whether another process does. Nobody waits for anybody for long; where the file system has no locks, nobody is
/// seen.
///
/// The locks are those of fcntl(2): children don't inherit them, and they tell who holds them.

#include <filesystem>
#include <optional>

namespace nodal {

class StoreLock {
 public:
  explicit StoreLock(const std::filesystem::path& directory);
  ~StoreLock();
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;

  /// The process of another comparison that writes here now.
  [[nodiscard]] std::optional<int> other_writer() const noexcept;

  /// While it lives no other process is in such a scope, unless that one stays for over a second: for reading, changing
  /// and writing the manifest.
  class Alone {
   public:
    explicit Alone(const StoreLock& lock) noexcept;
    ~Alone();
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;

   private:
    const StoreLock& lock_;
  };

 private:
  int descriptor_;
};

}  // namespace nodal
