// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The program's standard streams while a command runs: nothing that a terminal would obey gets through, whatever is
/// printed, and what could not be written is not passed over.
///
/// Closed   A standard descriptor that is closed is opened on /dev/null, the wrong way round, so that no file of the
///          program's own takes its place, and using it is an error.
/// SIGPIPE  is ignored: a reader that has gone must not end the program before its files are written.

#include <signal.h>

#include <memory>
#include <ostream>
#include <string_view>

namespace nodal {

class ConsoleBuffer;

/// Takes over std::cout and std::cerr, and puts everything back. One at a time.
class Console {
 public:
  Console();
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Flushes, and says what the program's exit code is. 2 and a message where standard output could not be written; 141
  /// without a word, as the shell calls an end by SIGPIPE, where its reader had gone and the command itself went well.
  [[nodiscard]] int finish(int exit);

 private:
  struct sigaction former_ {};
  std::unique_ptr<ConsoleBuffer> out_, err_;
  std::streambuf *former_out_ = nullptr, *former_err_ = nullptr;
};

/// "warning: …", a line on std::cerr: line breaks in the text are shown, too.
void say(std::string_view kind, std::string_view text);

/// Writes a sequence that the terminal is to obey, such as "\r": the program's own, never a text from elsewhere.
void send_control(std::ostream& out, std::string_view sequence);

}  // namespace nodal
