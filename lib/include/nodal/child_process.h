// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A function that runs in a forked copy of this process and sends one line back through a pipe.
///
/// The child leads a process group of its own: keys of the terminal (Ctrl-C, Ctrl-Z) and signals to the program's group
/// don't reach it, and `kill` ends what it has started, too. SIGINT, SIGTERM and SIGHUP it ignores: the parent decides
/// what becomes of it. SIGPIPE has its default. It dies with its parent, and leaves by _exit.
///
/// Nothing here waits for the child, whatever it does to its descriptors: it has ended when its line is whole, or when
/// its process has gone. End of file alone means neither.
///
/// Threads  fork copies the calling thread only: call from a process without other threads.

#include <functional>
#include <string>
#include <string_view>

namespace nodal {

class ChildProcess {
 public:
  /// std::system_error when the process or its pipe can't be made.
  explicit ChildProcess(const std::function<std::string()>& work);
  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To wait for with poll(2): readable when something is to be read. -1 once the child has closed its end.
  [[nodiscard]] int descriptor() const noexcept { return pipe_; }
  /// Reads what is there and looks what has become of the process. True when its line is whole or it has gone.
  [[nodiscard]] bool ended();
  /// The line without its newline, or what there is of one.
  [[nodiscard]] std::string_view output() const noexcept { return std::string_view(output_).substr(0, length_); }
  [[nodiscard]] bool whole() const noexcept { return whole_; }
  /// How it died, e.g. "signal 11 (Segmentation fault)"; empty when it lives, or left with exit status 0.
  [[nodiscard]] const std::string& death() const noexcept { return death_; }
  [[nodiscard]] bool died_of_signal() const noexcept { return died_of_signal_; }
  /// Stopped now; stopped or continued at some time, as far as was seen.
  [[nodiscard]] bool is_stopped() const noexcept { return is_stopped_; }
  [[nodiscard]] bool was_stopped() const noexcept { return was_stopped_; }
  /// Ends it and the processes of its group.
  void kill() noexcept;

 private:
  void read_what_is_there();
  void look_at_process();
  void note(int status);
  void close_pipe() noexcept;

  int process_ = -1;  ///< -1 when it was waited for
  int group_ = -1;
  int pipe_ = -1;
  std::string output_, death_;
  std::size_t length_ = 0;
  bool whole_ = false, died_of_signal_ = false, is_stopped_ = false, was_stopped_ = false;
};

}  // namespace nodal
