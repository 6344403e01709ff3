// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A descriptor closed by its owner, and what the toolkit does with one: write all, or say why not.

#include <sys/types.h>

#include <filesystem>
#include <string_view>

namespace nodal {

/// StoreError "cannot write '<path>': <why>", and what became of the content before.
[[noreturn]] void refuse_write(const std::filesystem::path& path, int error);

/// With all above it; StoreError.
void make_directory(const std::filesystem::path& path);

class FileDescriptor {
 public:
  /// Opened for writing with `flags`. `shown` stands in messages: a temporary file is spoken of by the name that it
  /// will have. StoreError.
  FileDescriptor(const std::filesystem::path& path, int flags, mode_t mode, std::filesystem::path shown);
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  [[nodiscard]] int get() const noexcept { return descriptor_; }
  /// All of it, or StoreError.
  void write(std::string_view text);
  /// To the disk; StoreError.
  void flush();
  [[nodiscard]] off_t size() const noexcept;
  /// Empty, or its last byte is a newline. Needs a descriptor that can read.
  [[nodiscard]] bool ends_a_line() const noexcept;
  /// Back to where a line began, so that a line cut off by a full disk does not swallow the next one.
  void cut_to(off_t size) noexcept;

 private:
  std::filesystem::path shown_;
  int descriptor_;
};

}  // namespace nodal
