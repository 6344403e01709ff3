// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A function that runs in a forked copy of this process and sends one text back through a pipe.
///
/// The child ignores SIGINT (the parent decides what becomes of it), has the default for SIGTERM and SIGPIPE, dies with
/// its parent, and leaves by _exit.
/// Threads  fork copies the calling thread only: call from a process without other threads.

#include <sys/types.h>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace nodal {

class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// std::system_error when the process or its pipe can't be made.
  ChildProcess(const std::function<std::string()>& work, Clock::time_point deadline);
  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To wait for with poll(2): readable when something is to be read, or the child has gone.
  [[nodiscard]] int descriptor() const noexcept { return pipe_; }
  [[nodiscard]] Clock::time_point deadline() const noexcept { return deadline_; }
  /// Reads what is there. True once the child has closed its end; then call `finish`.
  [[nodiscard]] bool read_more();
  /// Waits for the end. Empty when it ended well and `output()` is whole; else how it died, e.g. "signal 11
  /// (Segmentation fault)".
  [[nodiscard]] std::optional<std::string> finish();
  [[nodiscard]] const std::string& output() const noexcept { return output_; }
  void kill() noexcept;

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
  Clock::time_point deadline_;
  std::string output_;
};

}  // namespace nodal
