// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Who else writes to a store: every comparison holds a shared lock on the store's file `.lock` until it leaves, and
/// asks whether another process does. Nobody waits for anybody for long; where there are no locks, nobody is seen, and
/// `trouble` says why.
///
/// The locks are those of fcntl(2): children don't inherit them, and they tell who holds them.

#include <filesystem>
#include <optional>
#include <string>

namespace nodal {

class StoreLock {
 public:
  explicit StoreLock(const std::filesystem::path& directory);
  ~StoreLock();
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;

  /// Why nobody is seen, "Is a directory"; empty where all is well.
  [[nodiscard]] const std::string& trouble() const noexcept { return trouble_; }

  /// The process of another comparison that writes here now.
  [[nodiscard]] std::optional<int> other_writer() const noexcept;

  /// This process no longer writes here: others don't see it any more.
  void release() noexcept;

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
  std::string trouble_;
};

}  // namespace nodal
